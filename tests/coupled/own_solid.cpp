// SPDX-License-Identifier: MIT
// A solver of one's own coupled to Rivage: a plate on a spring. The text of docs/coupling.md is this file.
#include "coupler_lib/coupling/mpi_session.hpp"
#include "coupler_lib/coupling/participant.hpp"
#include "coupler_lib/coupling/solid_interface.hpp"

int main(int argc, char** argv)
{
    const coupler::MpiSession mpi(argc, argv, "solid", 30.0); // MPI_Init, given up after 30 s
    coupler::ParticipantSettings who;
    who.role = "solid";
    who.expected_roles = {"fluid", "solid"};
    coupler::Participant me(who); // from here on me.comm() is my world
    try {
        coupler::WetSurface wet; // the body lies on the left of a segment from its first to its second node
        wet.node_ids = {0, 1};
        wet.reference = {1, 0, 0, 0}; // (1, 0) and (0, 0) [m]
        wet.facet_ids = {0};
        wet.facet_nodes = {{0, 1, -1, -1}};
        coupler::SolidInterface fluid(me, {}, wet);
        const double mass = 100, stiffness = 1e6; // [kg/m], [N/m^2]
        double u = 0, v = 0;
        for (coupler::Window window; !window.last;) {
            coupler::SurfaceLoad load;
            coupler::FluidReport report;
            window = fluid.receive(load, report); // load n, the time, the next dt
            const double force = load.force[1] + load.force[3];
            const double a = (force - stiffness * u) / mass;
            fluid.send({{1, u, 0, u}, {0, v, 0, v}, {0, a, 0, a}}, {}); // where the surface is, at that time
            v += window.dt * a;
            u += window.dt * v;
        }
        me.finish();
    } catch (const base::Error& error) {
        me.report_failure(error); // every other rank ends with this message
        return static_cast<int>(error.code());
    }
    return 0;
}

// SPDX-License-Identifier: MIT
// The solid: large-deformation finite elements with implicit HHT dynamics, alone or coupled to a fluid.
//
//     fem_solver cases/gate_static/solid.toml
//     mpirun -n 1 sph_solver cases/elastic_gate/coupling.toml : -n 1 fem_solver cases/elastic_gate/coupling.toml
#include "coupler_lib/session/session.hpp"
#include "fem_solver/solid_simulation.hpp"

int main(int argc, char** argv)
{
    const coupler::ProgramInfo program{"fem_solver", "solid",
                                       "A deformable solid by finite elements, alone or coupled to a fluid.",
                                       [](base::ConfigReader& reader) { fem::read_solid_config(reader); }};
    return coupler::run_program(program, argc, argv, [](coupler::Session& session) {
        base::ConfigReader reader = session.reader();
        const fem::SolidConfig config = fem::read_solid_config(reader);
        fem::SolidSimulation simulation(config, session);
        session.check_only() ? simulation.check() : simulation.run();
    });
}

// SPDX-License-Identifier: MIT
// The fluid: Riemann-SPH for water with a violent free surface, in 2D and 3D, alone or coupled to a solid.
//
//     mpirun -n 2 sph_solver cases/dam_break/fluid.toml
//     mpirun -n 1 sph_solver cases/elastic_gate/coupling.toml : -n 1 fem_solver cases/elastic_gate/coupling.toml
#include "coupler_lib/session/session.hpp"
#include "sph_solver/fluid_simulation.hpp"
#include "sph_solver/return_memory.hpp"

namespace {

template<int D> void simulate(const sph::FluidConfig& config, coupler::Session& session)
{
    sph::FluidSimulation<D> simulation(config, session);
    if (session.check_only()) return simulation.check();
    simulation.run();
}

} // namespace

int main(int argc, char** argv)
{
    sph::return_freed_memory();
    const coupler::ProgramInfo program{"sph_solver", "fluid",
                                       "Water with a violent free surface by Riemann-SPH, alone or coupled to a solid.",
                                       [](base::ConfigReader& reader) { sph::read_fluid_config(reader); }};
    return coupler::run_program(program, argc, argv, [](coupler::Session& session) {
        base::ConfigReader reader = session.reader();
        const sph::FluidConfig config = sph::read_fluid_config(reader);
        config.domain.dimension == 2 ? simulate<2>(config, session) : simulate<3>(config, session);
    });
}

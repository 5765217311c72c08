// SPDX-License-Identifier: MIT
// Time of an implicit step of a cube in space, fixed at one end and swinging under gravity, with one of the solvers of
// linear systems:
//
//     mpirun -n 2 bench_block gamg 32        32^3 hexa8, 107,811 unknowns (sparse: one rank only)
//
// The first step orders and factorises (or sets up the multigrid), two more keep that: the difference is what it takes. Every
// time is the slowest rank's; memory is the largest rank's.
#include "coupler_lib/coupling/mpi_session.hpp"
#include "fem_solver/mesh/block_mesh.hpp"
#include "fem_solver/time/solid_step.hpp"
#include "tests/fem_solver/support/distributed.hpp"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace fem;

constexpr double step_length = 1e-4; // [s], a fluid's at dx = 4 mm and c0 = 30 m/s
constexpr int kept_steps = 2;

StepSettings settings(const std::string& method)
{
    using Petsc = PetscSettings::Method;
    StepSettings settings;
    settings.solver.method = method == "sparse" ? SolverSettings::Method::sparse : SolverSettings::Method::petsc;
    settings.solver.petsc.method = method == "gamg" ? Petsc::gmres_gamg : Petsc::mumps;
    return settings;
}

/// Largest resident memory of this rank so far [MB].
double peak_memory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

struct Report {
    std::string bench;
    const base::Communicator& comm;

    void say(const char* metric, double mine) const
    {
        const double value = comm.max(mine);
        if (!comm.is_root()) return;
        std::printf("{\"bench\": \"%s\", \"metric\": \"%s\", \"value\": %.4g, \"ranks\": %d}\n", bench.c_str(), metric,
                    value, comm.size());
        std::fflush(stdout);
    }
};

class Clock {
public:
    /// Seconds since the last call.
    double lap()
    {
        const double now = MPI_Wtime(), seconds = now - last_;
        last_ = now;
        return seconds;
    }

private:
    double last_ = MPI_Wtime();
};

void run(const base::Communicator& comm, const std::string& method, int cells)
{
    const Report report{"fem_block_" + method + "_" + std::to_string(cells), comm};
    const Mesh mesh =
        fem_test::distributed(make_block({ElementType::hexa8, {0, 0, 0}, {0.1, 0.1, 0.1}, {cells, cells, cells}}));
    SolidForces forces(mesh, {NeoHookean{Lame::from_young(12e6, 0.4)}, 1100}, {});
    forces.set_gravity({0, 0, -9.81});
    Supports supports(mesh);
    supports.fix("left", {"x", "y", "z"});
    SolidStep step(mesh, forces, supports, Hht(-0.05), settings(method));
    Motion motion = Motion::at_rest(forces.dofs());
    step.start(motion);
    report.say("unknowns", 3 * std::pow(cells + 1.0, 3));

    Clock clock;
    step.advance(motion, step_length);
    const double first = clock.lap();
    report.say("first_step_s", first);
    const long iterations = step.iterations(), factorisations = step.factorisations();
    clock.lap();
    for (int k = 0; k < kept_steps; ++k) step.advance(motion, step_length);
    const double kept = clock.lap() / kept_steps;
    report.say("kept_step_s", kept);
    report.say("newton_iterations_per_kept_step", static_cast<double>(step.iterations() - iterations) / kept_steps);
    report.say("factorisations_in_kept_steps", static_cast<double>(step.factorisations() - factorisations));
    report.say("order_and_factorise_s", first - kept);
    report.say("peak_memory_per_rank_MB", peak_memory());
}

} // namespace

int main(int argc, char** argv)
{
    const coupler::MpiSession mpi(argc, argv, "bench_block", 30.0);
    const std::string method = argc > 1 ? argv[1] : "";
    if (method != "sparse" && method != "mumps" && method != "gamg") {
        std::fprintf(stderr, "usage: bench_block sparse|mumps|gamg [CELLS]\n");
        return 2;
    }
    run(base::Communicator::world(), method, argc > 2 ? std::atoi(argv[2]) : 32);
    return 0;
}

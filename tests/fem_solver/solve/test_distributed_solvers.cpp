// SPDX-License-Identifier: MIT
// Every solver of linear systems finds the same answer, on any number of ranks. Every rank runs every test: EXPECT_* only.
#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/assembly/pressure_load.hpp"
#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/dofs/supports.hpp"
#include "fem_solver/mesh/block_mesh.hpp"
#include "fem_solver/solve/band_solver.hpp"
#include "fem_solver/solve/make_linear_solver.hpp"
#include "tests/fem_solver/support/distributed.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using Method = SolverSettings::Method;
using Petsc = PetscSettings::Method;

/// A cantilever block under a traction: K u = f, with rows and columns of the clamp cleared.
struct Cantilever {
    Mesh mesh;
    SolidForces forces;
    Matrix stiffness;
    Eigen::VectorXd load;

    Cantilever(const Mesh& part, bool clamped = true)
        : mesh(part), forces(mesh, {SmallElastic{Lame::from_young(12e6, 0.3)}, 1000}, {})
    {
        Supports supports(mesh);
        if (clamped) supports.fix("left", {"x", "y", "z"});
        stiffness = forces.initial_stiffness();
        supports.clear(stiffness, 1e5);
        load = traction_force(mesh, mesh.faces("right"), {1, -10, 3});
        supports.clear_rows(load);
    }
};

const BlockSpec beam{ElementType::hexa8, {0, 0, 0}, {0.4, 0.1, 0.1}, {12, 3, 3}};

Eigen::VectorXd exact(const Mesh& mesh)
{
    const Cantilever alone(make_block(beam));
    BandSolver solver;
    solver.factorise(alone.stiffness);
    const Eigen::VectorXd whole = solver.solve(alone.load);
    Eigen::VectorXd here(std::ssize(mesh.coordinates));
    for (int i = 0; i < mesh.nodes(); ++i) here.segment<3>(3 * i) = whole.segment<3>(3 * mesh.node_id(i));
    return here;
}

TEST(PetscSolver, FindsWhatTheBandedSolverFinds)
{
    const Cantilever beam_part(fem_test::distributed(make_block(beam)));
    const Eigen::VectorXd expected = exact(beam_part.mesh);
    for (const Petsc method : {Petsc::mumps, Petsc::gmres_gamg, Petsc::gmres_hypre}) {
        PetscSolver solver({method, 1e-12, ""}, beam_part.mesh, beam_part.forces.map());
        for (int round = 0; round < 2; ++round) { // the second matrix takes the first one's place
            solver.factorise((1.0 + round) * beam_part.stiffness);
            const Eigen::VectorXd u = solver.solve((1.0 + round) * beam_part.load);
            EXPECT_LT((u - expected).norm(), 1e-8 * expected.norm()) << static_cast<int>(method);
        }
        if (method == Petsc::gmres_gamg) EXPECT_LT(solver.iterations(), 30); // knows the rigid motions
    }
}

TEST(PetscSolver, TakesOptionsOfItsOwn)
{
    const Cantilever beam_part(fem_test::distributed(make_block(beam)));
    PetscSolver solver({Petsc::gmres_gamg, 1e-12, "-solver_ksp_max_it 2"}, beam_part.mesh, beam_part.forces.map());
    solver.factorise(beam_part.stiffness);
    std::string message;
    try {
        solver.solve(beam_part.load);
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::numerical_failure);
        message = error.what();
    }
    EXPECT_NE(message.find("did not converge in 2 iterations"), std::string::npos) << message;
    PetscSolver({Petsc::mumps, 1e-12, "-solver_ksp_max_it 1000"}, beam_part.mesh, beam_part.forces.map());
}

TEST(MakeLinearSolver, KnowsWhatRunsOnHowManyRanks)
{
    const Cantilever beam_part(fem_test::distributed(make_block(beam)));
    const auto make = [&](Method method) {
        return make_linear_solver({method, {}}, beam_part.mesh, beam_part.forces.map(), beam_part.stiffness);
    };
    const bool alone = beam_part.mesh.team().size() == 1;
    EXPECT_EQ(dynamic_cast<BandSolver*>(make(Method::automatic).get()) != nullptr, alone);
    for (const Method method : {Method::banded, Method::sparse}) {
        std::string message;
        Eigen::VectorXd u;
        try {
            const auto solver = make(method);
            solver->factorise(beam_part.stiffness);
            u = solver->solve(beam_part.load);
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::bad_input);
            message = error.what();
        }
        EXPECT_EQ(message.empty(), alone) << message;
        if (alone) EXPECT_LT((u - exact(beam_part.mesh)).norm(), 1e-8 * u.norm());
    }
}

} // namespace

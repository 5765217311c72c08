// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/time/solid_step.hpp"
#include "fem_solver/time/static_solution.hpp"
#include "tests/fem_solver/support/gate.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

struct Rest {
    double ux, uy, reaction_x, reaction_y, strain_energy;
    std::vector<double> residuals;
};

Rest settle(Gate& gate, int load_steps = 4)
{
    gate.add_water();
    StaticSolution solution(gate.mesh, gate.forces, gate.supports, {1e-11, 25, 0.1});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    solution.solve(motion, load_steps, [](double) {});
    const auto reaction = gate.supports.reaction("top", solution.reaction());
    return {motion.displacement[gate.tip],
            motion.displacement[gate.tip + 1],
            reaction[0],
            reaction[1],
            gate.forces.strain_energy(motion),
            solution.residuals()};
}

void expect_tip(const Rest& rest, double ux_mm, double uy_mm, double tolerance)
{
    EXPECT_NEAR(1e3 * rest.ux / ux_mm, 1, tolerance);
    EXPECT_NEAR(1e3 * rest.uy / uy_mm, 1, tolerance);
}

// References: converged plane-strain solutions of two other finite element codes.
TEST(GateStatic, QuadraticElementsOfNeoHookeanRubber)
{
    Gate gate(ElementType::quad8, rubber(), {}, {6, 80});
    const Rest rest = settle(gate);
    expect_tip(rest, 35.934, 10.132, 0.003);
    EXPECT_NEAR(rest.reaction_x / -67.88, 1, 0.003);
    EXPECT_NEAR(rest.reaction_y / -38.60, 1, 0.003);
    EXPECT_NEAR(rest.strain_energy / 0.6836, 1, 0.003);
}

TEST(GateStatic, TheGatesOwnMeshOfFourByForty)
{
    Gate gate(ElementType::quad8, rubber());
    const Rest rest = settle(gate);
    EXPECT_NEAR(1e3 * rest.ux / 35.934, 1, 0.003);
    EXPECT_NEAR(1e3 * rest.uy / 10.132, 1, 0.004);
}

TEST(GateStatic, SaintVenantKirchhoff)
{
    Gate gate(ElementType::quad8, SaintVenantKirchhoff{Lame::from_young(12e6, 0.4)}, {}, {6, 80});
    expect_tip(settle(gate), 35.969, 10.211, 0.003);
}

TEST(GateStatic, SofterRubber)
{
    Gate gate(ElementType::quad8, rubber(10e6), {}, {6, 80});
    expect_tip(settle(gate), 41.942, 14.295, 0.003);
}

TEST(GateStatic, NearlyIncompressible)
{
    Gate nine(ElementType::quad9, rubber(12e6, 0.499), {}, {6, 80});
    expect_tip(settle(nine), 32.373, 8.089, 0.003);
}

TEST(GateStatic, NineNodesAndTriangles)
{
    Gate nine(ElementType::quad9, rubber(), {}, {6, 80});
    expect_tip(settle(nine), 35.934, 10.132, 0.003);
    Gate six(ElementType::tri6, rubber(), {}, {6, 80});
    expect_tip(settle(six), 35.934, 10.132, 0.003);
}

TEST(GateStatic, LinearElementsWithTheirCure)
{
    Gate gate(ElementType::quad4, rubber());
    expect_tip(settle(gate), 35.934, 10.132, 0.02);
}

TEST(GateStatic, LinearElementsWithoutItLock)
{
    Gate gate(ElementType::quad4, rubber(), {false, Formulation::standard});
    EXPECT_LT(settle(gate).ux, 0.93 * 0.035934);
}

TEST(GateStatic, NewtonConvergesQuadratically)
{
    Gate gate(ElementType::quad8, rubber());
    const auto r = settle(gate).residuals;
    ASSERT_GE(r.size(), 4u);
    const auto n = r.size();
    EXPECT_LT(r[n - 2], 1e-3 * r[n - 3]);
    EXPECT_LT(r[n - 1], 1e-3 * r[n - 2]);
}

/// One load step with few iterations allowed: strides are cut, each is reported, and grow again; the answer is the same.
TEST(GateStatic, AStrideThatIsTooLongIsCut)
{
    Gate gate(ElementType::quad8, rubber(), {}, {2, 20});
    gate.add_water();
    const auto solve = [&](int load_steps, int max_iterations, std::vector<std::string>& cuts) {
        StaticSolution solution(gate.mesh, gate.forces, gate.supports, {1e-11, max_iterations, 0.1});
        solution.report_to([&](const std::string& line) { cuts.push_back(line); });
        Motion motion = Motion::at_rest(gate.forces.dofs());
        solution.solve(motion, load_steps, [](double) {});
        return motion.displacement[gate.tip];
    };
    std::vector<std::string> none, cuts;
    const double expected = solve(4, 25, none);
    EXPECT_NEAR(solve(1, 5, cuts), expected, 1e-9);
    EXPECT_TRUE(none.empty());
    ASSERT_FALSE(cuts.empty());
    EXPECT_NE(cuts.front().find("from load factor 0 to 1 (load step 1 of 1) did not converge in 6"), std::string::npos)
        << cuts.front();
}

/// Works of the load and of gravity are the strain energy, but for an error that falls fourfold with half the stride.
TEST(GateStatic, WorksAreTheStrainEnergy)
{
    Gate gate(ElementType::quad8, rubber(), {}, {2, 20});
    gate.add_water();
    gate.forces.set_gravity({0, -9.81});
    std::vector<double> errors;
    for (const int load_steps : {8, 16, 32}) {
        StaticSolution solution(gate.mesh, gate.forces, gate.supports, {1e-11, 25, 0.1});
        Motion motion = Motion::at_rest(gate.forces.dofs());
        solution.solve(motion, load_steps, [](double) {});
        EXPECT_GT(solution.energies().work_loads, 0.5);
        errors.push_back(std::abs(solution.energies().balance_error));
    }
    EXPECT_LT(errors[0], 0.01);
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]), 2, 0.2);
}

/// Equilibrium under gravity and the water as at t = 0, then HHT: nothing moves, although the load's factor is 1 only there.
TEST(GateStatic, AMotionThatStartsInEquilibriumStaysThere)
{
    Gate gate(ElementType::quad8, rubber(), {}, {2, 20});
    gate.forces.set_gravity({0, -9.81});
    const auto water = [](const double* x) { return 1000 * 9.81 * (0.14 - x[1]); };
    gate.forces.add_load(make_follower_pressure(gate.mesh, gate.forces.pattern(), gate.mesh.faces("left"), water),
                         "water", [](double t) { return t < 0.01 ? 1.0 : 0.0; });
    StaticSolution solution(gate.mesh, gate.forces, gate.supports, {{1e-11, 25, 0.1}, {}, LoadTime::start});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    solution.solve(motion, 4, [](double) {});
    const double settled = motion.displacement[gate.tip];
    EXPECT_GT(settled, 0.03);
    SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(-0.05), {{1e-11, 25, 0.1}});
    step.start(motion);
    for (int i = 0; i < 9; ++i) step.advance(motion, 1e-3);
    EXPECT_NEAR(motion.displacement[gate.tip], settled, 1e-9);
    EXPECT_LT(step.energies().kinetic, 1e-14 * step.energies().strain);
    for (int i = 0; i < 9; ++i) step.advance(motion, 1e-3); // the load is gone
    EXPECT_LT(motion.displacement[gate.tip], 0.95 * settled);
}

TEST(GateStatic, ABodyThatNothingHoldsIsReported)
{
    Gate gate(ElementType::quad8, rubber());
    gate.add_water();
    const Supports none(gate.mesh);
    StaticSolution solution(gate.mesh, gate.forces, none, {});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    try {
        solution.solve(motion, 1, [](double) {});
        FAIL() << "no error";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::numerical_failure);
        EXPECT_NE(std::string(error.what()).find("supports"), std::string::npos) << error.what();
    }
}

} // namespace

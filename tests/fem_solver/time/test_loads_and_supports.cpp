// SPDX-License-Identifier: MIT
// Loads over time, springs, moved supports: exact answers and their works.
#include "fem_solver/assembly/surface_traction.hpp"
#include "fem_solver/time/solid_step.hpp"
#include "fem_solver/time/static_solution.hpp"
#include "tests/fem_solver/support/gate.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace {

using namespace fem;
using namespace fem_test;

/// u = a (1 - cos w t)/2, with derivatives.
base::TimeFunction swing(double a, double w)
{
    return [=](double t) -> base::TimeValue {
        return {0.5 * a * (1 - std::cos(w * t)), 0.5 * a * w * std::sin(w * t), 0.5 * a * w * w * std::cos(w * t)};
    };
}

/// The same path for every node.
Supports::Path along(const base::TimeFunction& path)
{
    return [path](const double*) { return path; };
}

struct Cube {
    Mesh mesh = make_block({ElementType::hexa8, {0, 0, 0}, {1, 1, 1}, {2, 1, 1}});
    SolidForces forces;
    Supports supports{mesh};

    explicit Cube(const Law& law) : forces(mesh, {law, 1000}, {}) {}
    Eigen::VectorXd rest(int steps, std::vector<double>* reaction = nullptr)
    {
        StaticSolution solution(mesh, forces, supports, {1e-11, 30, 0.1});
        Motion motion = Motion::at_rest(forces.dofs());
        solution.solve(motion, steps, [](double) {});
        if (reaction) *reaction = supports.reaction("right", solution.reaction());
        return motion.displacement;
    }
};

/// A bar pulled to 1.5 times its length by a moved face, its sides free: 4093938 Pa, lateral stretch 0.85384989.
TEST(MovedSupport, PullsABar)
{
    Cube bar(rubber());
    bar.supports.fix("left", {"x"});
    bar.supports.fix("bottom", {"y"});
    bar.supports.fix("back", {"z"});
    bar.supports.prescribe("right", "x", along([](double t) -> base::TimeValue { return {0.5 * t, 0.5, 0}; }));
    std::vector<double> reaction;
    const Eigen::VectorXd u = bar.rest(3, &reaction);
    EXPECT_NEAR(reaction[0] / 4093938, 1, 1e-6);
    const int corner = bar.mesh.nearest_node({1, 1, 1});
    EXPECT_NEAR(u[3 * corner], 0.5, 1e-12);
    EXPECT_NEAR(1 + u[3 * corner + 1], 0.85384989, 1e-7);
    EXPECT_NEAR(1 + u[3 * corner + 2], 0.85384989, 1e-7);
}

/// A shaken clamp: displacement, velocity and acceleration are the path's own, and the books close to
/// round-off.
TEST(MovedSupport, ShakesTheGateAndTheBooksClose)
{
    for (const double alpha : {0.0, -0.05, -0.3}) {
        Gate gate(ElementType::quad8, rubber(), {}, {1, 8});
        gate.supports.prescribe("top", "x", along(swing(0.01, 40)));
        SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(alpha), {{1e-14, 50, 0.1}});
        Motion motion = Motion::at_rest(gate.forces.dofs());
        step.start(motion);
        double work = 0, error = 0;
        for (int i = 0; i < 200; ++i) {
            step.advance(motion, 5e-4);
            work = std::max(work, std::abs(step.energies().work_supports));
            error = std::max(error, std::abs(step.energies().balance_error));
        }
        EXPECT_LT(error, 1e-10 * work) << "alpha " << alpha; // what the nodal forces' round-off, 1e-10 N, leaves
        const int dof = 2 * gate.mesh.group_nodes("top").front();
        const base::TimeValue now = swing(0.01, 40)(0.1);
        EXPECT_NEAR(motion.displacement[dof], now.value, 1e-14);
        EXPECT_NEAR(motion.velocity[dof], now.rate, 1e-12);
        EXPECT_NEAR(motion.acceleration[dof], now.acceleration, 1e-10);
        EXPECT_GT(work, 1e-3);
    }
}

/// A body carried as a whole: the work is its kinetic energy, and what the scheme itself holds,
/// dt^2 (beta - gamma/2) a.M a/2.
TEST(MovedSupport, CarriesABody)
{
    Gate gate(ElementType::quad8, rubber(), {}, {1, 4});
    Supports carried(gate.mesh);
    carried.prescribe("all", "x", along([](double t) -> base::TimeValue { return {t * t * t, 3 * t * t, 6 * t}; }));
    carried.fix("all", {"y"});
    SolidStep step(gate.mesh, gate.forces, carried, Hht(-0.05), {});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    step.start(motion);
    for (int i = 0; i < 100; ++i) step.advance(motion, 1e-2);
    const double mass = 1100 * 0.005 * 0.079;
    EXPECT_NEAR(step.energies().kinetic, 0.5 * mass * 9, 1e-10);
    EXPECT_NEAR(step.energies().work_supports - step.energies().numerical_dissipation, 0.5 * mass * 9, 1e-12);
    EXPECT_NEAR(step.energies().numerical_dissipation, 0.5 * mass * 36 * 1e-4 * (0.25 * 1.05 * 1.05 - 0.5 * 0.55),
                1e-9);
}

/// A turn about a skew axis with a shift: velocity and acceleration are the derivatives of the displacement.
TEST(RigidDrive, VelocityAndAccelerationAreDerivatives)
{
    const Eigen::Vector3d centre(0.1, -0.2, 0.3), axis(1, 2, -1), point(0.5, 0.7, -0.4);
    const RigidDrive drive(centre, axis, {swing(0.2, 3), swing(-0.1, 2), swing(0.3, 1)}, swing(1.5, 4));
    const auto place = [&](const Eigen::Vector3d& x, double t) {
        Eigen::Vector3d now = x;
        for (int k = 0; k < 3; ++k) now[k] += drive.displacement(x, k, t).value;
        return now;
    };
    const double t = 0.37, h = 1e-3;
    EXPECT_NEAR((place(point, t) - drive.centre(t)).norm(), (point - centre).norm(), 1e-14);
    EXPECT_NEAR((place(point, t) - place(centre, t)).dot(axis), (point - centre).dot(axis), 1e-14);
    for (int k = 0; k < 3; ++k) {
        const base::TimeValue now = drive.displacement(point, k, t);
        const auto differences =
            base::with_derivatives([&](double at) { return drive.displacement(point, k, at).value; }, h)(t);
        EXPECT_NEAR(now.rate, differences.rate, 1e-9);
        EXPECT_NEAR(now.acceleration, differences.acceleration, 1e-7);
    }
}

/// A gate that hangs on its driven head, which turns and shifts, and whose foot is moved as well: each group has its work, and
/// the books close.
TEST(RigidDrive, EachGroupHasItsWork)
{
    Gate gate(ElementType::quad8, rubber(), {}, {1, 8});
    Supports supports(gate.mesh);
    const auto still = [](double) { return base::TimeValue{}; };
    supports.drive("top", std::make_shared<RigidDrive>(Eigen::Vector3d(0.1025, 0.079, 0), Eigen::Vector3d(0, 0, 1),
                                                       std::array<base::TimeFunction, 3>{swing(0.01, 40), still, still},
                                                       swing(0.2, 30)));
    supports.prescribe("bottom", "x", along(swing(0.005, 60)));
    SolidStep step(gate.mesh, gate.forces, supports, Hht(-0.05), {{1e-14, 50, 0.1}});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    step.start(motion);
    for (int i = 0; i < 100; ++i) step.advance(motion, 5e-4);
    const SolidEnergies& e = step.energies();
    ASSERT_EQ(e.work_of_support.size(), 2u);
    EXPECT_GT(std::abs(e.work_of_support[1]), 1e-3);
    EXPECT_NEAR(e.work_of_support[0] + e.work_of_support[1], e.work_supports, 1e-14);
    EXPECT_LT(std::abs(e.balance_error), 1e-10 * std::abs(e.work_of_support[0]));
}

/// The end of a beam turned by an angle with its length left free: M = E I angle/L, the reaction's moment about the centre.
TEST(RigidDrive, MomentOfATurnedEnd)
{
    const double young = 1e6, length = 1, height = 0.05, angle = 0.02;
    const Mesh mesh = make_block({ElementType::quad8, {0, 0}, {length, height}, {20, 1}});
    const SolidForces forces(mesh, {SmallElastic{Lame::from_young(young, 0)}, 1000}, {});
    Supports supports(mesh);
    supports.fix("left", {"x", "y"});
    const auto still = [](double) { return base::TimeValue{}; };
    const auto rise = [=](double t) { return base::TimeValue{0.5 * length * angle * t, 0, 0}; };
    supports.drive("right",
                   std::make_shared<RigidDrive>(Eigen::Vector3d(length, 0.5 * height, 0), Eigen::Vector3d(0, 0, 1),
                                                std::array<base::TimeFunction, 3>{still, rise, still}, [=](double t) {
                                                    return base::TimeValue{angle * t, 0, 0};
                                                }));
    StaticSolution solution(mesh, forces, supports, {1e-11, 30, 0.1});
    Motion motion = Motion::at_rest(forces.dofs());
    solution.solve(motion, 1, [](double) {});
    const double expected = young * height * height * height / 12 * angle / length;
    EXPECT_NEAR(supports.moment(supports.driven().front(), 1, motion, solution.reaction())[2] / expected, 1, 1e-2);
}

/// A stiff block on springs, 2 N/m^3 over a unit face and 3 N/m at a node: what force / (sum of stiffnesses) gives.
TEST(SpringLoad, HoldsABlock)
{
    Cube block(rubber(1e6));
    block.supports.fix("all", {"y", "z"});
    block.forces.add_load(std::make_unique<Springs>(
        spring_stiffness(block.mesh, block.forces.pattern(), block.mesh.faces("left"), {2, 0, 0})));
    Matrix point = block.forces.pattern().zero();
    const int node = 3 * block.mesh.nearest_node({1, 0, 0});
    block.forces.pattern().add_entry(point, node, node, 3);
    block.forces.add_load(std::make_unique<Springs>(point));
    block.forces.add_load(
        std::make_unique<DeadLoad>(traction_force(block.mesh, block.mesh.faces("right"), {0.05, 0, 0})));
    EXPECT_NEAR(block.rest(2)[node], 0.01, 1e-6);
}

/// Mass on a spring with the average acceleration scheme: the spring's work is -k u^2/2, the period that of the scheme.
TEST(SpringLoad, SwingsAndItsWorkIsItsEnergy)
{
    Gate gate(ElementType::quad8, rubber(12e9), {}, {1, 2});
    Supports rail(gate.mesh);
    rail.fix("all", {"y"});
    const double stiffness = 400, mass = 1100 * 0.005 * 0.079, w = std::sqrt(stiffness * 0.079 / mass), dt = 0.1 / w;
    gate.forces.add_load(std::make_unique<Springs>(spring_stiffness(gate.mesh, gate.forces.pattern(),
                                                                    gate.mesh.faces("left"), {stiffness, 0})),
                         "spring");
    SolidStep step(gate.mesh, gate.forces, rail, Hht(0), {{1e-12, 50, 0.1}});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    for (int i = 0; i < gate.mesh.nodes(); ++i) motion.displacement[2 * i] = 0.01;
    step.start(motion);
    const double angle = 2 * std::atan(0.05); // turn of the average acceleration scheme in a step of w dt = 0.1
    for (int i = 1; i <= 50; ++i) {
        step.advance(motion, dt);
        const double u = motion.displacement[gate.tip];
        EXPECT_NEAR(u, 0.01 * std::cos(angle * i), 1e-7);
        EXPECT_NEAR(step.energies().work_of_load[0], 0.5 * stiffness * 0.079 * (1e-4 - u * u), 1e-8);
    }
}

/// Loads that change over time: each has its work, and together they are the loads' work.
TEST(TimeFactor, ScalesALoadAndSharesTheWork)
{
    Gate gate(ElementType::quad8, rubber(), {}, {1, 8});
    const auto add = [&](double traction, const char* name, SolidForces::TimeFactor factor) {
        gate.forces.add_load(
            std::make_unique<DeadLoad>(traction_force(gate.mesh, gate.mesh.faces("left"), {traction, 0})), name,
            factor);
    };
    add(1000, "ramp", [](double t) { return t / 0.01; });
    add(500, "burst", [](double t) { return t < 0.005 ? 1.0 : 0.0; });
    SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(-0.05), {{1e-14, 50, 0.1}});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    step.start(motion);
    for (int i = 0; i < 100; ++i) step.advance(motion, 1e-4);
    const SolidEnergies& e = step.energies();
    EXPECT_NEAR(step.forces().loads.sum(), 1000 * 0.079, 1e-10); // the burst is over
    ASSERT_EQ(e.work_of_load.size(), 2u);
    EXPECT_GT(e.work_of_load[1], 0);
    EXPECT_NEAR(e.work_of_load[0] + e.work_of_load[1], e.work_loads, 1e-12 * e.work_loads);
    EXPECT_LT(std::abs(e.balance_error), 1e-12 * e.work_loads);
}

} // namespace

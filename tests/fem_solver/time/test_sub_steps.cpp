// SPDX-License-Identifier: MIT
// Several HHT steps within one step: asked for, or where one does not converge.
#include "fem_solver/time/solid_step.hpp"
#include "tests/fem_solver/support/gate.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

/// A gate that a fluid presses on: nodal forces of a window, the same in x on all nodes of its wet face.
struct WetGate : Gate {
    WetGate() : Gate(ElementType::quad8, rubber(), {}, {1, 8})
    {
        auto load = std::make_unique<DeadLoad>(Eigen::VectorXd::Zero(forces.dofs()));
        fluid = load.get();
        forces.set_interface_load(std::move(load));
        add_water();
        forces.set_gravity({0, -9.81});
    }
    void press(double force)
    {
        Eigen::VectorXd all = Eigen::VectorXd::Zero(forces.dofs());
        for (const int node : mesh.group_nodes("left")) all[2 * node] = force;
        fluid->set(all);
    }
    DeadLoad* fluid;
};

double pushed(int window) { return 2 * std::sin(0.7 * window); }

TEST(SubSteps, AreStepsWithTheFluidsLoadInBetween)
{
    const int parts = 4, windows = 12;
    const double dt = 4e-3;
    WetGate one, many;
    SolidStep coarse(one.mesh, one.forces, one.supports, Hht(-0.05),
                     {{1e-14, 50, 0.1}, Predictor::constant_acceleration, parts});
    SolidStep fine(many.mesh, many.forces, many.supports, Hht(-0.05), {{1e-14, 50, 0.1}});
    Motion motion = Motion::at_rest(one.forces.dofs()), expected = motion;
    coarse.start(motion);
    fine.start(expected);
    for (int n = 1; n <= windows; ++n) {
        one.press(pushed(n));
        coarse.advance(motion, dt);
        for (int k = 1; k <= parts; ++k) {
            many.press(pushed(n - 1) + (pushed(n) - pushed(n - 1)) * k / parts);
            fine.advance(expected, dt / parts);
        }
    }
    EXPECT_EQ(coarse.steps(), windows);
    EXPECT_EQ(coarse.sub_steps(), windows * parts);
    EXPECT_NEAR(motion.displacement[one.tip], expected.displacement[one.tip], 1e-12);
    EXPECT_GT(std::abs(expected.displacement[one.tip]), 0.01);
    EXPECT_NEAR(coarse.energies().work_interface, fine.energies().work_interface, 1e-11);
    EXPECT_LT(std::abs(coarse.energies().balance_error), 1e-11 * coarse.energies().work_loads);
}

/// With few iterations long steps fail: they are cut and joined again, time goes on as asked, and the books close.
TEST(SubSteps, AStepThatDoesNotConvergeIsCutAndTheBooksClose)
{
    WetGate gate;
    SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(-0.05), {{1e-13, 6, 0.1}});
    std::vector<std::string> cuts;
    step.report_to([&](const std::string& line) { cuts.push_back(line); });
    Motion motion = Motion::at_rest(gate.forces.dofs());
    step.start(motion);
    double work = 0;
    for (int n = 1; n <= 10; ++n) {
        gate.press(pushed(n));
        step.advance(motion, 1e-2);
        work = std::max(work, std::abs(step.energies().work_loads));
    }
    ASSERT_FALSE(cuts.empty());
    EXPECT_NE(cuts.front().find("did not converge"), std::string::npos) << cuts.front();
    EXPECT_NE(cuts.front().find("half of it is tried"), std::string::npos) << cuts.front();
    EXPECT_GT(step.sub_steps(), step.steps());
    EXPECT_LT(step.sub_steps(), 16 * step.steps()); // joined again
    EXPECT_LT(std::abs(step.energies().balance_error), 1e-11 * work);
}

} // namespace

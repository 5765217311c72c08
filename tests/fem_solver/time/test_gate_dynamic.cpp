// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/time/solid_step.hpp"
#include "tests/fem_solver/support/gate.hpp"

#include <gtest/gtest.h>

#include <array>

namespace {

using namespace fem;
using namespace fem_test;

/// The water's pressure switched on at t = 0. References: a converged finite element solution.
TEST(GateSudden, FollowsTheConvergedMotion)
{
    Gate gate(ElementType::quad8, rubber());
    gate.add_water();
    SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(-0.05), {});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    step.start(motion);
    const double dt = 2e-4;
    double at_20_ms = 0, at_40_ms = 0;
    std::array<double, 2> peak{}, peak_time{}; // of the first and the second swing
    for (int i = 1; i <= 520; ++i) {
        step.advance(motion, dt);
        const double ux = 1e3 * motion.displacement[gate.tip];
        if (i == 100) at_20_ms = ux;
        if (i == 200) at_40_ms = ux;
        const int swing = i < 330 ? 0 : 1;
        if (ux > peak[swing]) peak_time[swing] = i * dt;
        peak[swing] = std::max(peak[swing], ux);
    }
    EXPECT_NEAR(at_20_ms, 44.75, 0.2);
    EXPECT_NEAR(at_40_ms, 56.8, 0.3);
    EXPECT_NEAR(peak[0], 60.6, 0.3);
    EXPECT_NEAR(peak_time[1] - peak_time[0], 0.0665, 0.0003);
    EXPECT_LT(std::abs(step.energies().balance_error), 1e-8 * step.energies().numerical_dissipation + 1e-8);
}

TEST(GateSudden, AFailedStepNamesNodeAndStep)
{
    Gate gate(ElementType::quad8, rubber());
    gate.add_water();
    SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(-0.05), {{1e-9, 1, 0.1}}); // one iteration is too few
    Motion motion = Motion::at_rest(gate.forces.dofs());
    step.start(motion);
    try {
        for (int i = 0; i < 50; ++i) step.advance(motion, 1e-3);
        FAIL() << "no error";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::numerical_failure);
        const std::string what = error.what();
        EXPECT_NE(what.find("the solid's step"), std::string::npos) << what;
        EXPECT_NE(what.find("reference position (0.1"), std::string::npos) << what;
    }
}

} // namespace

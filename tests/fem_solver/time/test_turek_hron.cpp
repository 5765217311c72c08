// SPDX-License-Identifier: MIT
// The elastic beam behind a cylinder under its own weight (S. Turek, J. Hron, Fluid-Structure Interaction,
// 2006, CSM1-3).
#include "fem_solver/time/solid_step.hpp"
#include "tests/fem_solver/support/bench.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

/// From the cylinder of radius 0.05 m at (0.2, 0.2) to x = 0.6 m, 0.02 m thick.
struct Flag : Bench {
    explicit Flag(double young)
        : Bench(
              ElementType::quad8, {70, 6},
              [](double s, double t) -> std::array<double, 2> {
                  const double y = 0.19 + 0.02 * t, start = 0.2 + std::sqrt(0.0025 - (y - 0.2) * (y - 0.2));
                  return {start + s * (0.6 - start), y};
              },
              SaintVenantKirchhoff{Lame::from_young(young, 0.4)})
    {
        supports.fix("left", {"x", "y"});
        forces.set_gravity({0, -2});
    }
    int tip() const { return 2 * mesh.nearest_node({0.6, 0.2}); }
};

TEST(TurekHron, AtRest)
{
    Flag soft(1.4e6), stiff(5.6e6);
    const Eigen::VectorXd u1 = soft.rest(4), u2 = stiff.rest(2);
    EXPECT_NEAR(u1[soft.tip()] / -7.187e-3, 1, 0.003);
    EXPECT_NEAR(u1[soft.tip() + 1] / -66.10e-3, 1, 0.003);
    EXPECT_NEAR(u2[stiff.tip()] / -0.469e-3, 1, 0.003);
    EXPECT_NEAR(u2[stiff.tip() + 1] / -16.97e-3, 1, 0.003);
}

TEST(TurekHron, FirstSwing)
{
    Flag flag(1.4e6);
    SolidStep step(flag.mesh, flag.forces, flag.supports, Hht(-0.02), {});
    Motion motion = Motion::at_rest(flag.forces.dofs());
    step.start(motion);
    double lowest = 0;
    for (int i = 0; i < 240; ++i) {
        step.advance(motion, 2.5e-3);
        lowest = std::min(lowest, motion.displacement[flag.tip() + 1]);
    }
    EXPECT_NEAR(lowest, -129.5e-3, 0.2e-3);
}

} // namespace

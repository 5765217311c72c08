// SPDX-License-Identifier: MIT
// Where Newton's iteration starts must not matter to where it ends.
#include "fem_solver/time/solid_step.hpp"
#include "tests/fem_solver/support/gate.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

struct Swung {
    double tip, velocity; ///< ux [m] and its rate [m/s]
    long iterations;
};

/// A gate under water that is there at once, after some steps of unequal length.
Swung swing_from(Predictor predictor)
{
    Gate gate(ElementType::quad8, rubber(), {}, {1, 8});
    gate.add_water();
    SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(-0.05), {{1e-12, 50, 0.1}, predictor});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    step.start(motion);
    for (int n = 0; n < 20; ++n) step.advance(motion, n % 3 == 0 ? 1e-3 : 2e-3);
    return {motion.displacement[gate.tip], motion.velocity[gate.tip], step.iterations()};
}

TEST(Predictor, LeadsToTheSameMotion)
{
    const Swung usual = swing_from(Predictor::constant_acceleration);
    EXPECT_GT(std::abs(usual.tip), 0.01);
    for (const Predictor predictor : {Predictor::continued, Predictor::still}) {
        const Swung other = swing_from(predictor);
        EXPECT_NEAR(other.tip, usual.tip, 1e-9 * std::abs(usual.tip));
        EXPECT_NEAR(other.velocity, usual.velocity, 1e-7 * std::abs(usual.velocity));
        EXPECT_NE(other.iterations, usual.iterations) << "another start was asked for";
    }
}

} // namespace

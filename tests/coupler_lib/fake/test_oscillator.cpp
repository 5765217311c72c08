// SPDX-License-Identifier: MIT
#include "coupler_lib/fake/oscillator.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace {

using coupler::Oscillator;
using coupler::OscillatorConfig;

OscillatorConfig config(const std::string& integrator, double alpha)
{
    OscillatorConfig made;
    made.mass = 2.0;
    made.stiffness = 2.0;
    made.displacement = 1.0;
    made.integrator = integrator;
    made.alpha = alpha;
    return made;
}

TEST(Oscillator, FollowsTheHhtRecurrence)
{
    Oscillator piston(config("hht", -0.1));
    piston.start(0.0);
    const double exact[] = {0.882965650418398, 0.559811409716339, 0.106599826414678}; // w dt = 0.5, u0 = 1, v0 = 0
    for (const double u : exact) {
        piston.advance({}, 0.5);
        EXPECT_NEAR(piston.displacement(), u, 1e-14);
    }
}

TEST(Oscillator, ClosesItsEnergyUnderAnyLoadImpedanceAndStep)
{
    for (const char* integrator : {"hht", "exact"}) {
        auto made = config(integrator, -0.2);
        made.gravity = -9.81;
        Oscillator piston(made);
        piston.start(3.0);
        for (int k = 0; k < 200; ++k) {
            piston.advance({5 * std::sin(1.7 * k), k % 3 * 0.5, 0.1 * std::cos(k)}, 0.05 + 0.03 * (k % 4));
            EXPECT_NEAR(piston.balance_error(), 0.0, 1e-12 * (1 + std::abs(piston.work()) + piston.strain()))
                << integrator << k;
        }
        EXPECT_GT(std::abs(piston.work()), 1.0);
    }
}

TEST(Oscillator, IsExactUnderAConstantLoad)
{
    auto made = config("exact", 0.0);
    made.gravity = 0.5;
    Oscillator piston(made);
    piston.start(3.0);
    const double rest = (3.0 + 2.0 * 0.5) / 2.0;
    for (int k = 0; k < 10; ++k) piston.advance({3.0, 0, 0}, 0.37);
    EXPECT_NEAR(piston.displacement(), rest + (1.0 - rest) * std::cos(3.7), 1e-13);
    EXPECT_NEAR(piston.velocity(), -(1.0 - rest) * std::sin(3.7), 1e-13);
}

TEST(Oscillator, TakesTheImpedanceAsADamper)
{
    // load = Z vbar turns the correction into a plain damper: m u'' + Z u' + k u = 0, Z = 0.8, damping ratio 0.2.
    Oscillator exact(config("exact", 0.0)), hht(config("hht", 0.0));
    exact.start(0.0);
    hht.start(0.0);
    constexpr int steps = 4000;
    for (int k = 0; k < steps; ++k) {
        exact.advance({0, 0.8, 0}, 4.0 / steps);
        hht.advance({0, 0.8, 0}, 4.0 / steps);
    }
    const double wd = std::sqrt(1 - 0.04);
    const double u = std::exp(-0.8) * (std::cos(4 * wd) + 0.2 / wd * std::sin(4 * wd));
    EXPECT_NEAR(exact.displacement(), u, 1e-11);
    EXPECT_NEAR(hht.displacement(), u, 2e-6);
}

TEST(Oscillator, OverdampedMotionIsExactToo)
{
    Oscillator piston(config("exact", 0.0));
    piston.start(0.0);
    for (int k = 0; k < 8; ++k) piston.advance({0, 10.0, 0}, 0.25); // roots -1/2 (5 +- sqrt 21)
    const double root = std::sqrt(21.0), slow = -(5 - root) / 2, fast = -(5 + root) / 2;
    EXPECT_NEAR(piston.displacement(), (slow * std::exp(2 * fast) - fast * std::exp(2 * slow)) / (slow - fast), 1e-12);
}

TEST(Oscillator, RefusesWhatCannotBe)
{
    auto bad = config("hht", -0.5);
    EXPECT_THROW(Oscillator{bad}, base::Error);
    bad = config("hht", 0.0);
    bad.mass = 0;
    EXPECT_THROW(Oscillator{bad}, base::Error);
}

} // namespace

// SPDX-License-Identifier: MIT
#include "sph_solver/time/time_step.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace sph {
namespace {

const TimeStepSettings settings{.cfl = 0.6, .smoothing_length = 1.23e-3, .sound_speed = 30.0};
constexpr double foot = 0.6 * 1.23e-3 / 30.0;

double next(TimeStep& step, double sound_speed)
{
    Particles<2> particles;
    particles.resize(2);
    particles.own_all();
    particles.sound_speed = {0.9 * sound_speed, sound_speed};
    return step.next(particles, base::Communicator::self());
}

TEST(TimeStep, StandsOnTheLadder)
{
    TimeStep step(settings);
    EXPECT_DOUBLE_EQ(next(step, 30.0), foot);
    EXPECT_DOUBLE_EQ(next(step, 60.0), foot / 2);
    EXPECT_DOUBLE_EQ(next(step, 30.0), foot);
}

TEST(TimeStep, IsHeldWhileTheSoundSpeedWavers)
{
    TimeStep step(settings);
    for (int k = 0; k < 50; ++k) EXPECT_DOUBLE_EQ(next(step, 30.0 * (1.02 + 0.03 * std::sin(k))), foot);
}

TEST(TimeStep, KeepsTheCourantNumberWithinSevenPercent)
{
    TimeStep step(settings);
    for (double c = 30.0; c < 45.0; c += 0.05) EXPECT_LE(next(step, c) * c / 1.23e-3, 0.6 * 1.07);
    for (double c = 45.0; c > 30.0; c -= 0.05) EXPECT_LE(next(step, c) * c / 1.23e-3, 0.6 * 1.07);
}

TEST(TimeStep, GoesOnFromItsRung)
{
    TimeStep before(settings), after(settings);
    next(before, 32.0);
    after.set_rung(before.rung());
    EXPECT_EQ(next(before, 31.5), next(after, 31.5));
}

TEST(TimeStep, MayBePrescribed)
{
    TimeStepSettings fixed = settings;
    fixed.fixed_dt = 1e-5;
    TimeStep step(fixed);
    EXPECT_EQ(next(step, 77.0), 1e-5);
}

TEST(TimeStep, WithoutFluidTakesTheFoot)
{
    TimeStep step(settings);
    EXPECT_DOUBLE_EQ(step.next(Particles<2>{}, base::Communicator::self()), foot);
}

TEST(TimeStep, RefusesSizesThatAreNotPositive)
{
    TimeStepSettings wrong = settings;
    wrong.cfl = 0;
    EXPECT_THROW(TimeStep{wrong}, base::Error);
}

} // namespace
} // namespace sph

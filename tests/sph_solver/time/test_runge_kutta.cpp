// SPDX-License-Identifier: MIT
#include "sph_solver/time/runge_kutta.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/time/stage_update.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace sph {
namespace {

/// Two particles that circle the origin, with volume and mass that decay: every conserved field has its exact course.
double error_after(const RungeKutta& method, int steps)
{
    constexpr double end = 1.0;
    Particles<2> particles;
    particles.resize(2);
    particles.own_all();
    for (std::size_t i = 0; i < 2; ++i) {
        particles.position[i] = Vec<2>(1.0 + static_cast<double>(i), 0.0);
        particles.mass[i] = particles.volume[i] = 1.0;
        particles.momentum[i] = Vec<2>(0.0, 1.0 + static_cast<double>(i));
    }
    StageUpdate<2> update;
    Rates<2> rates;
    for (int step = 0; step < steps; ++step) {
        update.start(particles);
        for (const Stage& stage : method.stages()) {
            rates.reset(2);
            for (std::size_t i = 0; i < 2; ++i) {
                particles.velocity[i] = particles.momentum[i];
                rates.momentum[i] = -particles.position[i];
                rates.mass[i] = -particles.mass[i];
                rates.volume[i] = -2 * particles.volume[i];
            }
            update.apply(particles, stage, rates, end / steps);
        }
    }
    const double radius = 2.0;
    return (particles.position[1] - radius * Vec<2>(std::cos(end), std::sin(end))).norm() +
           (particles.momentum[1] - radius * Vec<2>(-std::sin(end), std::cos(end))).norm() +
           std::abs(particles.mass[1] - std::exp(-end)) + std::abs(particles.volume[1] - std::exp(-2 * end));
}

double observed_order(const std::string& name)
{
    const RungeKutta method(name);
    return std::log2(error_after(method, 20) / error_after(method, 40));
}

TEST(RungeKutta, HasItsOrder)
{
    EXPECT_NEAR(observed_order("rk2"), 2.0, 0.15);
    EXPECT_NEAR(observed_order("hybrid3"), 2.0, 0.15);
    EXPECT_NEAR(observed_order("rk3"), 3.0, 0.15);
    EXPECT_NEAR(observed_order("rk4"), 4.0, 0.15);
}

TEST(RungeKutta, WeightsIntegrateConstantAndLinearRates)
{
    for (const char* name : {"rk2", "rk3", "rk4", "hybrid3"}) {
        const RungeKutta method(name);
        double sum = 0, moment = 0;
        for (const Stage& stage : method.stages()) {
            sum += stage.weight;
            moment += stage.weight * stage.time;
        }
        EXPECT_NEAR(sum, 1.0, 1e-15) << name;
        EXPECT_NEAR(moment, 0.5, 1e-15) << name;
        EXPECT_EQ(method.stages().back().next, 0.0) << name;
    }
}

TEST(RungeKutta, FirstStageMakesSlopes)
{
    for (const char* name : {"rk2", "rk3", "rk4", "hybrid3"})
        EXPECT_EQ(RungeKutta(name).stages().front().slopes, Slopes::made) << name;
}

TEST(RungeKutta, UnknownNameIsAnInputError)
{
    try {
        RungeKutta method("leapfrog");
        ADD_FAILURE() << "accepted";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::bad_input);
        EXPECT_NE(std::string(error.what()).find("leapfrog"), std::string::npos);
    }
}

} // namespace
} // namespace sph

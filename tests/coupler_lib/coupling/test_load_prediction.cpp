// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/load_prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace coupler;

/// Unequal steps from t = 0.
double step_length(int n, double size) { return size * (1 + 0.3 * (n % 3)); }

/// Loads of a force over time as a fluid sends them: at t = 0, then means over the last step; `action` gets each of them with the
/// end of the step that it is for.
template<class Mean, class Action> void steps(int count, double size, const Mean& mean, Action&& action)
{
    double t = 0;
    for (int n = 0; n < count; ++n) {
        const double dt = step_length(n, size), last = n > 0 ? step_length(n - 1, size) : 0;
        action(n, mean(t - last, t), t + dt, dt);
        t += dt;
    }
}

TEST(LaggedLoad, IsTheLoad)
{
    SurfaceLoad load;
    load.force = {1, 2};
    make_lagged_load()->apply(load, {0, 0}, 0.1);
    EXPECT_EQ(load.force, (std::vector<double>{1, 2}));
}

/// A force that grows linearly is met exactly at the end of the step, whatever the steps.
TEST(ExtrapolatedLoad, MeetsALinearForce)
{
    const auto prediction = make_extrapolated_load();
    steps(
        8, 0.01, [](double a, double b) { return 3 + 5 * 0.5 * (a + b); },
        [&](int n, double mean, double end, double dt) {
            SurfaceLoad load;
            load.force = {mean};
            load.pressure = {2 * mean};
            prediction->apply(load, {0}, dt);
            if (n == 0) return;
            EXPECT_NEAR(load.force[0], 3 + 5 * end, 1e-12);
            EXPECT_NEAR(load.pressure[0], 2 * (3 + 5 * end), 1e-12);
        });
}

TEST(ExtrapolatedLoad, IsOfSecondOrder)
{
    double worst[2] = {0, 0};
    for (int round = 0; round < 2; ++round) {
        const auto prediction = make_extrapolated_load();
        const double size = round == 0 ? 0.02 : 0.01;
        steps(
            static_cast<int>(1 / size), size,
            [](double a, double b) { return b > a ? (std::cos(a) - std::cos(b)) / (b - a) : std::sin(a); },
            [&](int n, double mean, double end, double dt) {
                SurfaceLoad load;
                load.force = {mean};
                prediction->apply(load, {0}, dt);
                if (n > 0) worst[round] = std::max(worst[round], std::abs(load.force[0] - std::sin(end)));
            });
    }
    EXPECT_NEAR(worst[0] / worst[1], 4, 0.4);
}

/// A wall in uniform acceleration: the reference ends up at the velocity of the end of the step, so nothing is answered.
TEST(SmoothedReference, KnowsAUniformAcceleration)
{
    const auto prediction = make_smoothed_reference(1);
    const double a = 5;
    double t = 0, last = 0;
    for (int n = 0; n < 6; ++n) {
        const double dt = step_length(n, 0.01);
        SurfaceLoad load;
        load.wall_velocity = {a * (t - 0.5 * last)}; // while the load was measured
        prediction->apply(load, {a * t}, dt);
        if (n > 0) {
            EXPECT_NEAR(load.wall_velocity[0], a * (t + dt), 1e-12);
        }
        t += dt;
        last = dt;
    }
}

/// A jump of the velocity is news: the more steps, the less of it is taken off.
TEST(SmoothedReference, LeavesAJumpToBeAnswered)
{
    double off[2];
    for (const int steps_of : {1, 20}) {
        const auto prediction = make_smoothed_reference(steps_of);
        SurfaceLoad load;
        load.wall_velocity = {0};
        prediction->apply(load, {0}, 0.01);
        load.wall_velocity = {0};
        prediction->apply(load, {1}, 0.01);
        off[steps_of == 1 ? 0 : 1] = load.wall_velocity[0];
    }
    EXPECT_NEAR(off[0], 1.5, 1e-12);
    EXPECT_NEAR(off[1], 1.5 / 20, 1e-12);
}

} // namespace

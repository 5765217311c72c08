// SPDX-License-Identifier: MIT
#include "fem_solver/time/hht.hpp"
#include "tests/fem_solver/support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace fem;
using fem_test::record;

/// u'' + w^2 u = 0 from u = 1 at rest: displacements after each of `steps` steps.
std::vector<double> oscillate(double alpha, double w_dt, int steps)
{
    const Hht hht(alpha);
    Motion motion = Motion::at_rest(1);
    motion.displacement[0] = 1;
    motion.acceleration[0] = -1; // w = 1, so dt = w dt
    double force_n = 1;
    std::vector<double> history;
    for (int i = 0; i < steps; ++i) {
        hht.predict(motion, w_dt);
        const auto residual = [&] {
            return motion.acceleration[0] + (1 + alpha) * motion.displacement[0] - alpha * force_n;
        };
        const double tangent = hht.acceleration_slope(w_dt) + 1 + alpha;
        hht.correct(motion, Eigen::VectorXd::Constant(1, -residual() / tangent), 1, w_dt);
        EXPECT_NEAR(residual(), 0, 1e-14);
        force_n = motion.displacement[0];
        history.push_back(force_n);
    }
    return history;
}

TEST(Hht, RecurrenceOfOneDegreeOfFreedom)
{
    const auto u = oscillate(-0.1, 0.5, 3);
    EXPECT_NEAR(u[0], 0.882965650418398, 1e-14);
    EXPECT_NEAR(u[1], 0.559811409716339, 1e-14);
    EXPECT_NEAR(u[2], 0.106599826414678, 1e-14);
    for (int i = 0; i < 3; ++i) record("hht_u" + std::to_string(i + 1), u[i]);
}

TEST(Hht, BothPredictionsLeadToTheSameStep)
{
    const Hht hht(-0.05);
    const double dt = 0.3;
    Motion start{Eigen::VectorXd::Constant(1, 0.4), Eigen::VectorXd::Constant(1, -0.7),
                 Eigen::VectorXd::Constant(1, 1.1)};
    Motion moving = start, still = start;
    hht.predict(moving, dt);
    hht.predict_still(still, dt);
    hht.correct(moving, still.displacement - moving.displacement, 1, dt);
    EXPECT_NEAR(moving.velocity[0], still.velocity[0], 1e-14);
    EXPECT_NEAR(moving.acceleration[0], still.acceleration[0], 1e-13);
}

/// Error after ten seconds falls by four when the step is halved.
TEST(Hht, IsSecondOrder)
{
    for (const double alpha : {0.0, -0.05, -0.3}) {
        std::vector<double> errors;
        for (const int steps : {200, 400, 800})
            errors.push_back(std::abs(oscillate(alpha, 10.0 / steps, steps).back() - std::cos(10.0)));
        for (int i = 0; i < 2; ++i) EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]), 2, 0.06) << "alpha " << alpha;
        if (alpha == -0.05) record("hht_order", std::log2(errors[1] / errors[2]));
    }
}

/// Amplitude after many periods against the asymptotic damping ratio -alpha (1 + alpha)^2 (w dt)^3 / 8.
TEST(Hht, DampsAsItsExpansionSays)
{
    const double alpha = -0.1, w_dt = 0.1;
    const int steps = 20000;
    const auto u = oscillate(alpha, w_dt, steps);
    double early = 0, late = 0;
    for (int i = 0; i < 200; ++i) {
        early = std::max(early, std::abs(u[i]));
        late = std::max(late, std::abs(u[steps - 200 + i]));
    }
    const double ratio = std::log(early / late) / (w_dt * (steps - 200));
    const double expected = -alpha * (1 + alpha) * (1 + alpha) * std::pow(w_dt, 3) / 8;
    EXPECT_NEAR(ratio / expected, 1, 0.05);
    record("hht_damping_over_expansion", ratio / expected);
}

/// Period, from the last upward crossing of zero, against the asymptotic error (w dt)^2 (1/12 - alpha/4 - 3 alpha^2/8).
TEST(Hht, LengthensThePeriodAsItsExpansionSays)
{
    for (const double alpha : {0.0, -0.1, -0.3})
        for (const double w_dt : {0.05, 0.1}) {
            const auto u = oscillate(alpha, w_dt, static_cast<int>(200 / w_dt));
            double crossing = 0;
            int crossings = 0;
            for (std::size_t i = 1; i < u.size(); ++i)
                if (u[i - 1] < 0 && u[i] >= 0) {
                    crossing = (static_cast<double>(i) + u[i - 1] / (u[i - 1] - u[i])) * w_dt;
                    ++crossings;
                }
            const double error = crossing / (2 * M_PI * (crossings - 0.25)) - 1;
            const double expected = w_dt * w_dt * (1.0 / 12 - alpha / 4 - 3 * alpha * alpha / 8);
            EXPECT_NEAR(error / expected, 1, 0.05) << "alpha " << alpha << ", w dt " << w_dt;
            if (alpha == -0.1 && w_dt == 0.05) record("hht_period_error_over_expansion", error / expected);
        }
}

} // namespace

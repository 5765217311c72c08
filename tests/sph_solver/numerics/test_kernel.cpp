// SPDX-License-Identifier: MIT
#include "sph_solver/numerics/kernel.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

/// Integral of W over space by Simpson's rule in r, with a node at r = h where the spline's pieces meet.
template<int D> double volume_integral(const CubicSpline<D>& kernel)
{
    constexpr int intervals = 400;
    const double step = kernel.support() / intervals;
    double sum = 0;
    for (int k = 0; k <= intervals; ++k) {
        const double r = k * step;
        const double shell = D == 2 ? 2 * std::numbers::pi * r : 4 * std::numbers::pi * r * r;
        const double simpson = k == 0 || k == intervals ? 1 : (k % 2 == 1 ? 4 : 2);
        sum += simpson * shell * kernel.value(r);
    }
    return sum * step / 3;
}

template<int D> void expect_slope_is_derivative(const CubicSpline<D>& kernel)
{
    const double step = 1e-5 * kernel.smoothing_length();
    const double scale = kernel.value(0) / kernel.smoothing_length();
    for (double s = 0.013; s < 2.2; s += 0.061) {
        const double r = s * kernel.smoothing_length();
        const double difference = (kernel.value(r + step) - kernel.value(r - step)) / (2 * step);
        EXPECT_NEAR(kernel.derivative(r), difference, 1e-8 * scale) << "s = " << s;
        EXPECT_EQ(kernel.derivative(r), -kernel.slope(r));
    }
}

TEST(CubicSpline, IntegratesToOne)
{
    EXPECT_NEAR(volume_integral(CubicSpline<2>(0.0123)), 1.0, 1e-9);
    EXPECT_NEAR(volume_integral(CubicSpline<3>(0.7)), 1.0, 1e-9);
}

TEST(CubicSpline, SlopeIsTheDerivative)
{
    expect_slope_is_derivative(CubicSpline<2>(0.0123));
    expect_slope_is_derivative(CubicSpline<3>(0.7));
}

TEST(CubicSpline, IsZeroBeyondTwoSmoothingLengths)
{
    const CubicSpline<2> kernel(0.5);
    EXPECT_EQ(kernel.support(), 1.0);
    EXPECT_GT(kernel.value(0.999), 0.0);
    EXPECT_LT(kernel.derivative(0.999), 0.0);
    for (const double r : {1.0, 1.0001, 7.0}) {
        EXPECT_EQ(kernel.value(r), 0.0);
        EXPECT_EQ(kernel.slope(r), 0.0);
    }
}

TEST(CubicSpline, HasTheTabledValues)
{
    const CubicSpline<3> kernel(1.0);
    EXPECT_NEAR(kernel.value(0), 1 / std::numbers::pi, 1e-15);
    EXPECT_NEAR(kernel.value(1), 0.25 / std::numbers::pi, 1e-15);
    EXPECT_EQ(kernel.slope(0.0), 0.0);
    EXPECT_NEAR(kernel.slope(1.0), 0.75 / std::numbers::pi, 1e-15);
}

TEST(CubicSpline, PackGivesTheSameBits)
{
    const CubicSpline<2> kernel(0.0123);
    const Pack slopes = kernel.slope(Pack{0.001, 0.0123, 0.02, 0.03});
    EXPECT_EQ(slopes[0], kernel.slope(0.001));
    EXPECT_EQ(slopes[1], kernel.slope(0.0123));
    EXPECT_EQ(slopes[2], kernel.slope(0.02));
    EXPECT_EQ(slopes[3], 0.0);
}

} // namespace
} // namespace sph

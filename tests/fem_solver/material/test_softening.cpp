// SPDX-License-Identifier: MIT
#include "fem_solver/material/shape_law.hpp"
#include "tests/fem_solver/support/consistent_law.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;

const Softening softening{1.6, 2e3, 0.1};
constexpr double peak = 5e4; // [J/m^3]

/// Integral of eta dpsi between two energies below the peak, by Simpson's rule.
double given_back(double low, double high)
{
    const auto eta = [](double psi) { return softening.factor(psi, peak).value; };
    const int steps = 2000;
    const double h = (high - low) / steps;
    double sum = eta(low) + eta(high);
    for (int k = 1; k < steps; ++k) sum += (k % 2 == 1 ? 4 : 2) * eta(low + k * h);
    return sum * h / 3;
}

TEST(Softening, StoresWhatComesBackAndLosesTheRest)
{
    EXPECT_NEAR(softening.stored(peak, peak), given_back(0, peak), 1e-9 * peak);
    EXPECT_NEAR(softening.stored(0.3 * peak, peak), given_back(0, 0.3 * peak), 1e-9 * peak);
    EXPECT_NEAR(softening.stored(0, peak), 0, 1e-12 * peak);
    EXPECT_NEAR(softening.stored(peak, peak) + softening.lost(peak), peak, 1e-12 * peak); // up: all of psi's work
    EXPECT_GT(softening.lost(peak), 0.3 * peak);
    EXPECT_EQ(softening.lost(0), 0);
}

TEST(Softening, FactorHasItsSlopeAndIsOneOnTheWayUp)
{
    EXPECT_EQ(softening.factor(1.1 * peak, peak).value, 1);
    EXPECT_EQ(softening.factor(peak, peak).slope, 0);
    for (const double psi : {0.1 * peak, 0.6 * peak, 0.97 * peak}) {
        const double h = 1e-5 * peak;
        const double slope = (softening.factor(psi + h, peak).value - softening.factor(psi - h, peak).value) / (2 * h);
        EXPECT_NEAR(softening.factor(psi, peak).slope, slope, 1e-7 * slope + 1e-12 / peak);
    }
}

/// The law at one point, which has been stretched before.
template<int D> ShapeLaw<D> worn()
{
    ShapeLaw<D> law(make_point_law<D>(Law{NeoHookean{{-2e6 * 2 / 3, 2e6}}}), softening, 1);
    Tensor<D> far = Tensor<D>::Identity();
    far(0, 0) = 1.5;
    far(1, 1) = 1 / 1.5;
    law.accept(0, far);
    return law;
}

/// A ShapeLaw at its first point.
template<int D> struct AtFirst {
    const ShapeLaw<D>& law;
    double energy(const Tensor<D>& f) const { return law.energy(0, f); }
    Tensor<D> stress(const Tensor<D>& f) const { return law.stress(0, f); }
    Tangent<D> tangent(const Tensor<D>& f) const { return law.tangent(0, f); }
};

template<int D> void expect_consistent_shape(const ShapeLaw<D>& law, const Tensor<D>& f)
{
    fem_test::expect_consistent<D>(AtFirst<D>{law}, f, 2e6);
}

TEST(ShapeLaw, BelowThePeakStressIsTheSlopeOfTheEnergyAndTangentThatOfTheStress)
{
    Eigen::Matrix3d f;
    f << 1.2, 0.1, 0.05, -0.08, 0.9, 0.1, 0.05, -0.1, 1.02;
    expect_consistent_shape<3>(worn<3>(), f);
    expect_consistent_shape<2>(worn<2>(), f.topLeftCorner<2, 2>());
}

TEST(ShapeLaw, WithoutSofteningIsTheLawItself)
{
    const Law law{NeoHookean{{1e6, 2e6}}};
    const auto plain = make_point_law<2>(law);
    ShapeLaw<2> same(make_point_law<2>(law), {}, 1);
    Eigen::Matrix2d f;
    f << 1.2, 0.1, -0.08, 0.9;
    EXPECT_FALSE(same.softens());
    EXPECT_EQ(same.stress(0, f), plain->stress(f));
    EXPECT_EQ(same.tangent(0, f), plain->tangent(f));
    EXPECT_EQ(same.energy(0, f), plain->energy(f));
}

} // namespace

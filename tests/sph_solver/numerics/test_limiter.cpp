// SPDX-License-Identifier: MIT
#include "sph_solver/numerics/muscl.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

/// The limited jump of a field with jump d and upstream jump u: phi = k (d + u).
template<class Limiter> double phi(double d, double u) { return Limiter{}.factor(d * u, d * d + u * u) * (d + u); }

TEST(VanAlbada, IsTheTextbookFormula)
{
    for (const double a : {0.3, 1.0, 7.0})
        for (const double b : {0.01, 1.0, 3.0}) {
            const double expected = a * b * (a + b) / (a * a + b * b);
            EXPECT_NEAR(phi<VanAlbada>(a, b), expected, 1e-13 * expected);
            EXPECT_NEAR(phi<VanAlbada>(-a, -b), -expected, 1e-13 * expected);
            EXPECT_EQ(phi<VanAlbada>(a, -b), 0.0);
            EXPECT_EQ(phi<VanAlbada>(-a, b), 0.0);
        }
}

TEST(VanAlbada, KeepsEqualSlopesAndIsSymmetric)
{
    EXPECT_NEAR(phi<VanAlbada>(0.7, 0.7), 0.7, 1e-15);
    EXPECT_NEAR(phi<VanAlbada>(0.2, 0.9), phi<VanAlbada>(0.9, 0.2), 1e-15);
}

TEST(VanAlbada, IsHomogeneousAndFiniteAtZero)
{
    EXPECT_EQ(phi<VanAlbada>(0.0, 0.0), 0.0);
    EXPECT_EQ(phi<VanAlbada>(1e-200, 1e-200), 0.0); // below what its squares can hold: first order
    EXPECT_DOUBLE_EQ(phi<VanAlbada>(0.2e-9, 0.9e-9), 1e-9 * phi<VanAlbada>(0.2, 0.9));
}

TEST(VanAlbada, FourAtOnceAreThoseOfEach)
{
    const std::array<double, 4> product = {0.2, -1.0, 3e-20, 0.0}, squares = {0.5, 2.0, 7e-20, 0.0};
    const auto four = VanAlbada{}.factors(product, squares);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(four[k], VanAlbada{}.factor(product[k], squares[k]), 1e-15) << k;
    const auto swapped = VanAlbada{}.factors(std::array{-1.0, 0.2, 0.0, 3e-20}, std::array{2.0, 0.5, 0.0, 7e-20});
    EXPECT_EQ(four[0], swapped[1]); // the pair seen from its other side: the same bits
    EXPECT_EQ(four[2], swapped[3]);
}

TEST(VanLeer, IsTheTextbookFormula)
{
    for (const double a : {0.3, 1.0, 7.0})
        for (const double b : {0.01, 1.0, 3.0}) {
            EXPECT_NEAR(phi<VanLeer>(a, b), 2 * a * b / (a + b), 1e-13);
            EXPECT_NEAR(phi<VanLeer>(-a, -b), -2 * a * b / (a + b), 1e-13);
            EXPECT_EQ(phi<VanLeer>(a, -b), 0.0);
            EXPECT_GE(phi<VanLeer>(a, b), phi<VanAlbada>(a, b) - 1e-15);
            const double p = a * b, q = a * a + b * b;
            EXPECT_NEAR(VanLeer{}.factors(std::array{p, -p, p, p}, std::array{q, q, 2 * q, q})[3],
                        VanLeer{}.factor(p, q), 1e-15);
        }
}

TEST(VanAlbada, NeverExceedsTheMean)
{
    for (double u = -3; u < 3; u += 0.01) EXPECT_LE(phi<VanAlbada>(1.0, u), std::max(0.5 * (1.0 + u), 0.0) + 1e-15);
}

TEST(Unlimited, TakesTheMeanSlope) { EXPECT_DOUBLE_EQ(phi<Unlimited>(1.0, -4.0), -1.5); }

TEST(FirstOrder, TakesNoSlope) { EXPECT_EQ(phi<FirstOrder>(1.0, 1.0), 0.0); }

} // namespace
} // namespace sph

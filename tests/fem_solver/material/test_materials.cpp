// SPDX-License-Identifier: MIT
#include "fem_solver/material/material.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace {

using namespace fem;

const Lame rubber = Lame::from_young(12e6, 0.4);

template<class LawType> class Laws : public testing::Test {};
using AllLaws = testing::Types<SmallElastic, SaintVenantKirchhoff, NeoHookean, NeoHookeanLog>;
TYPED_TEST_SUITE(Laws, AllLaws);

template<int D> Tensor<D> some_deformation()
{
    Tensor<D> f;
    if constexpr (D == 2)
        f << 1.2, 0.3, -0.15, 0.9;
    else
        f << 1.2, 0.3, 0.1, -0.15, 0.9, 0.2, 0.05, -0.1, 1.1;
    return f;
}

template<int D, class LawType> void expect_consistent(const LawType& law)
{
    const Tensor<D> f = some_deformation<D>();
    const Tensor<D> stress = law.template stress<D>(f);
    const Tangent<D> tangent = law.template tangent<D>(f);
    const double h = 1e-6;
    for (int j = 0; j < D; ++j)
        for (int i = 0; i < D; ++i) {
            Tensor<D> up = f, down = f;
            up(i, j) += h;
            down(i, j) -= h;
            const double slope = (law.template energy<D>(up) - law.template energy<D>(down)) / (2 * h);
            EXPECT_NEAR(slope, stress(i, j), 1e-8 * rubber.mu) << i << j;
            const Tensor<D> change = (law.template stress<D>(up) - law.template stress<D>(down)) / (2 * h);
            for (int l = 0; l < D; ++l)
                for (int k = 0; k < D; ++k)
                    EXPECT_NEAR(change(k, l), tangent(k + D * l, i + D * j), 1e-7 * rubber.mu) << k << l << i << j;
        }
}

TYPED_TEST(Laws, StressIsTheSlopeOfTheEnergyAndTangentThatOfTheStress)
{
    expect_consistent<2>(TypeParam{rubber});
    expect_consistent<3>(TypeParam{rubber});
}

TYPED_TEST(Laws, AreHookesLawAtSmallStrain)
{
    const TypeParam law{rubber};
    const Tangent<3> tangent = law.template tangent<3>(Tensor<3>::Identity());
    const double modulus = rubber.lambda + 2 * rubber.mu;
    EXPECT_NEAR(tangent(0, 0), modulus, 1e-9 * modulus);
    EXPECT_NEAR(tangent(0, 4), rubber.lambda, 1e-9 * modulus);
    EXPECT_NEAR(tangent(1, 1), rubber.mu, 1e-9 * modulus);
    EXPECT_NEAR(tangent(1, 3), rubber.mu, 1e-9 * modulus);
}

TEST(FiniteLaws, LeaveARotatedBodyUnstressed)
{
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(1.3, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    EXPECT_LT(NeoHookean{rubber}.stress<3>(rotation).norm(), 1e-8 * rubber.mu);
    EXPECT_LT(NeoHookeanLog{rubber}.stress<3>(rotation).norm(), 1e-8 * rubber.mu);
    EXPECT_LT(SaintVenantKirchhoff{rubber}.stress<3>(rotation).norm(), 1e-8 * rubber.mu);
}

TEST(FiniteLaws, PlaneStrainIsThreeDimensionalWithoutStretchAcross)
{
    Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
    full.topLeftCorner<2, 2>() = some_deformation<2>();
    const Eigen::Matrix3d stress = NeoHookean{rubber}.stress<3>(full);
    EXPECT_LT((stress.topLeftCorner<2, 2>() - NeoHookean{rubber}.stress<2>(some_deformation<2>())).norm(), 1e-6);
}

/// Bar of compressible neo-Hookean rubber pulled to 1.5 times its length, its lateral faces free: the lateral stretch
/// by Newton on P_22 = 0.
TEST(NeoHookeanLaw, UniaxialTension)
{
    const NeoHookean law{rubber};
    Eigen::Matrix3d f = Eigen::Vector3d(1.5, 1, 1).asDiagonal();
    for (int i = 0; i < 20; ++i) {
        const Tangent<3> a = law.tangent<3>(f);
        f(1, 1) = f(2, 2) -= law.stress<3>(f)(1, 1) / (a(4, 4) + a(4, 8));
    }
    EXPECT_NEAR(f(1, 1), 0.85384989, 1e-8);
    EXPECT_NEAR(law.stress<3>(f)(0, 0) / 4093938.0, 1, 1e-6);
}

TEST(NeoHookeanLaw, CauchyStressOfPureVolumeChange)
{
    const double stretch = 1.1, j = stretch * stretch * stretch;
    const Eigen::Matrix3d f = stretch * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d sigma = cauchy_stress<NeoHookean, 3>(NeoHookean{rubber}, f);
    EXPECT_LT((sigma - rubber.bulk() * (j - 1) * Eigen::Matrix3d::Identity()).norm(), 1e-8 * rubber.bulk());
}

} // namespace

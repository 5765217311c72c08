// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/material/point_law.hpp"
#include "fem_solver/material/stability.hpp"
#include "tests/fem_solver/support/consistent_law.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace {

using namespace fem;

constexpr double mu = 4e6, bulk = 40 * mu;

Ogden two_terms(double k) { return {OgdenEnergy{{{3e6, 1.3}, {1e6, -2.0}}}, k}; }

/// A curve that softens and stiffens again.
std::shared_ptr<const UniaxialCurve> measured()
{
    return std::make_shared<UniaxialCurve>(std::vector<double>{0.05, 0.1, 0.2, 0.4, 0.8, 1.5},
                                           std::vector<double>{0.55e6, 1.0e6, 1.7e6, 2.7e6, 4.0e6, 9.0e6});
}
Marlow marlow(double k) { return {{measured()}, k}; }

/// The same shape with its volume part off: pressure is free then.
double nominal_stress(const Law& law, double stretch)
{
    const Eigen::Matrix3d f = Eigen::Vector3d(stretch, 1 / std::sqrt(stretch), 1 / std::sqrt(stretch)).asDiagonal();
    const Eigen::Matrix3d p = make_point_law<3>(law)->stress(f);
    return p(0, 0) - p(1, 1) * f(1, 1) / f(0, 0); // a pressure that frees the sides
}

class RubberLaws : public testing::TestWithParam<Law> {};

template<int D> void expect_consistent_law(const Law& law, const Tensor<D>& f)
{
    const auto point = make_point_law<D>(law);
    fem_test::expect_consistent<D>(*point, f, point->shear_modulus());
}

TEST_P(RubberLaws, StressIsTheSlopeOfTheEnergyAndTangentThatOfTheStress)
{
    Eigen::Matrix3d f;
    f << 1.2, 0.3, 0.1, -0.15, 0.9, 0.2, 0.05, -0.1, 1.1;
    expect_consistent_law<3>(GetParam(), f);
    expect_consistent_law<2>(GetParam(), f.topLeftCorner<2, 2>());
}

/// Two and three equal stretches, where the principal directions are not unique.
TEST_P(RubberLaws, EqualStretchesAreNoSpecialCase)
{
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    const Eigen::Matrix3d two = turn * Eigen::Vector3d(1.3, 1.3, 0.8).asDiagonal();
    expect_consistent_law<3>(GetParam(), two);
    expect_consistent_law<3>(GetParam(), 1.05 * turn);
    const Eigen::Matrix3d close = turn * Eigen::Vector3d(1.3, 1.3 + 1e-5, 0.8).asDiagonal();
    EXPECT_LT((make_point_law<3>(GetParam())->tangent(close) - make_point_law<3>(GetParam())->tangent(two)).norm(),
              1e-4 * bulk);
}

TEST_P(RubberLaws, AreHookesLawAtSmallStrainAndForgetRotations)
{
    const auto law = make_point_law<3>(GetParam());
    const Tangent<3> a = law->tangent(Eigen::Matrix3d::Identity());
    const double g = law->shear_modulus();
    EXPECT_NEAR(a(0, 0), bulk + 4 * g / 3, 1e-9 * bulk);
    EXPECT_NEAR(a(0, 4), bulk - 2 * g / 3, 1e-9 * bulk);
    EXPECT_NEAR(a(1, 3), g, 1e-9 * bulk);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.3, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    EXPECT_LT(law->stress(turn).norm(), 1e-12 * bulk);
}

INSTANTIATE_TEST_SUITE_P(All, RubberLaws,
                         testing::Values(Law(mooney_rivlin(1.6e6, 0.4e6, bulk)), Law(two_terms(bulk)),
                                         Law(marlow(bulk))));

TEST(MooneyRivlin, WithoutItsSecondTermIsNeoHookean)
{
    Eigen::Matrix3d f;
    f << 1.2, 0.3, 0.1, -0.15, 0.9, 0.2, 0.05, -0.1, 1.1;
    const NeoHookean direct{Lame{mu, bulk - 2 * mu / 3}};
    const Ogden spectral = mooney_rivlin(mu / 2, 0, bulk);
    EXPECT_LT((direct.stress<3>(f) - spectral.stress<3>(f)).norm(), 1e-13 * bulk);
    EXPECT_LT((direct.tangent<3>(f) - spectral.tangent<3>(f)).norm(), 1e-12 * bulk);
    EXPECT_NEAR(direct.energy<3>(f), spectral.energy<3>(f), 1e-13 * bulk);
}

/// Nominal stress at a stretch of 1.5, exact for an incompressible body: mu (l - l^-2), 2 (c10 + c01/l) (l - l^-2),
/// sum 2 mu/alpha (l^(alpha-1) - l^(-alpha/2-1)).
TEST(Uniaxial, StressOfAnIncompressibleBar)
{
    const double l = 1.5, t = l - 1 / (l * l);
    EXPECT_NEAR(nominal_stress(NeoHookean{Lame{mu, bulk}}, l) / 4.22222e6, 1, 1e-6);
    EXPECT_NEAR(nominal_stress(mooney_rivlin(1.6e6, 0.4e6, bulk), l) / 3.94074e6, 1, 1e-6);
    EXPECT_NEAR(nominal_stress(two_terms(bulk), l) / 3.55202e6, 1, 1e-6);
    EXPECT_NEAR(nominal_stress(NeoHookean{Lame{mu, bulk}}, l), mu * t, 1e-8 * mu);
    EXPECT_NEAR(nominal_stress(mooney_rivlin(1.6e6, 0.4e6, bulk), l), 2 * (1.6e6 + 0.4e6 / l) * t, 1e-8 * mu);
    const double first = 2 * 3e6 / 1.3 * (std::pow(l, 0.3) - std::pow(l, -1.65)), second = -1e6 * (std::pow(l, -3) - 1);
    EXPECT_NEAR(nominal_stress(two_terms(bulk), l), first + second, 1e-8 * mu);
}

/// A bar with free sides and a finite bulk modulus: away from the incompressible answer by no more than 2 mu/K.
TEST(Uniaxial, FreeSidesWithALargeBulkModulus)
{
    for (const double ratio : {1e3, 1e5})
        for (const auto& [law, exact] : {std::pair<Law, double>{mooney_rivlin(1.6e6, 0.4e6, ratio * mu), 3.94074e6},
                                         std::pair<Law, double>{two_terms(ratio * mu), 3.55202e6}}) {
            const auto point = make_point_law<3>(law);
            Eigen::Matrix3d f = Eigen::Vector3d(1.5, 0.8, 0.8).asDiagonal();
            for (int i = 0; i < 30; ++i) {
                const Tangent<3> a = point->tangent(f);
                f(1, 1) = f(2, 2) -= point->stress(f)(1, 1) / (a(4, 4) + a(4, 8));
            }
            EXPECT_NEAR(point->stress(f)(0, 0) / exact, 1, 2 / ratio + 1e-6);
        }
}

/// The tangent of a sheet is the slope of its stress, that the slope of its energy; its faces are free.
TEST(PlaneStress, IsConsistentForEveryLaw)
{
    Tensor<2> f;
    f << 1.2, 0.3, -0.15, 0.9;
    const Lame lame{mu, bulk - 2 * mu / 3};
    for (const Law& law : {Law(SmallElastic{lame}), Law(SaintVenantKirchhoff{lame}), Law(NeoHookean{lame}),
                           Law(two_terms(bulk)), Law(marlow(bulk))}) {
        const auto sheet = make_point_law<2>(Material{law, 1, Sheet::plane_stress});
        const Tangent<2> tangent = sheet->tangent(f);
        const double h = 1e-6;
        for (int c = 0; c < 4; ++c) {
            Tensor<2> up = f, down = f;
            up.reshaped()[c] += h;
            down.reshaped()[c] -= h;
            EXPECT_NEAR((sheet->energy(up) - sheet->energy(down)) / (2 * h), sheet->stress(f).reshaped()[c], 2e-8 * mu);
            const Tensor<2> change = (sheet->stress(up) - sheet->stress(down)) / (2 * h);
            for (int r = 0; r < 4; ++r) EXPECT_NEAR(change.reshaped()[r], tangent(r, c), 2e-7 * mu) << r << c;
        }
        EXPECT_NEAR(sheet->cauchy(f)(2, 2), 0, 1e-11 * bulk);
    }
}

/// A strip pulled to 1.5 with free edges is the bar with free sides: 4093938 Pa at a lateral stretch of 0.85384989.
TEST(PlaneStress, StripInTension)
{
    const auto sheet = make_point_law<2>(Material{NeoHookean{Lame::from_young(12e6, 0.4)}, 1, Sheet::plane_stress});
    Tensor<2> f = Eigen::Vector2d(1.5, 1).asDiagonal();
    for (int i = 0; i < 20; ++i) f(1, 1) -= sheet->stress(f)(1, 1) / sheet->tangent(f)(3, 3);
    EXPECT_NEAR(f(1, 1), 0.85384989, 1e-8);
    EXPECT_NEAR(sheet->stress(f)(0, 0) / 4093938.0, 1, 1e-6);
}

/// Hooke's sheet: E/(1 - nu^2) along, nu times that across.
TEST(PlaneStress, HookesModuli)
{
    const double young = 12e6, nu = 0.3, plate = young / (1 - nu * nu);
    const auto sheet = make_point_law<2>(Material{SmallElastic{Lame::from_young(young, nu)}, 1, Sheet::plane_stress});
    const Tangent<2> a = sheet->tangent(Tensor<2>::Identity());
    EXPECT_NEAR(a(0, 0), plate, 1e-9 * plate);
    EXPECT_NEAR(a(0, 3), nu * plate, 1e-9 * plate);
}

TEST(MarlowLaw, GivesBackItsCurveInTension)
{
    const std::vector<double> strain{0.05, 0.1, 0.2, 0.4, 0.8, 1.5}, stress{0.55e6, 1.0e6, 1.7e6, 2.7e6, 4.0e6, 9.0e6};
    for (std::size_t k = 0; k < strain.size(); ++k)
        EXPECT_NEAR(nominal_stress(marlow(bulk), 1 + strain[k]), stress[k], 1e-8 * stress[k]);
}

/// A curve measured on neo-Hookean rubber gives neo-Hookean rubber, in any deformation.
TEST(MarlowLaw, OfANeoHookeanCurveIsNeoHookean)
{
    std::vector<double> strain, stress;
    for (int k = 1; k < 8; ++k) {
        strain.push_back(0.2 * k);
        stress.push_back(mu * (1 + 0.2 * k - 1 / ((1 + 0.2 * k) * (1 + 0.2 * k))));
    }
    const Marlow law{{std::make_shared<UniaxialCurve>(strain, stress)}, bulk};
    const NeoHookean direct{Lame{mu, bulk - 2 * mu / 3}};
    for (const double shear : {0.0, 0.02, 0.4, 2.0}) {
        Eigen::Matrix3d f = Eigen::Matrix3d::Identity();
        f(0, 1) = shear;
        EXPECT_LT((law.stress<3>(f) - direct.stress<3>(f)).norm(), 1e-12 * bulk) << shear;
        EXPECT_NEAR(law.energy<3>(f), direct.energy<3>(f), 1e-10 * mu) << shear;
    }
}

TEST(UniaxialCurve, NamesABadPoint)
{
    const auto message = [](std::vector<double> strain, const std::vector<double>& stress) -> std::string {
        try {
            const UniaxialCurve curve(std::move(strain), stress);
        } catch (const base::Error& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_NE(message({0.1, 0.1}, {1, 2}).find("point 2: strain 0.1 does not ascend"), std::string::npos);
    EXPECT_NE(message({0.1, 0.2}, {1, -2}).find("point 2: stress -2 Pa"), std::string::npos);
    EXPECT_NE(message({}, {}).find("one point at least"), std::string::npos);
}

TEST(Drucker, FindsWhereALawSoftens)
{
    EXPECT_TRUE(drucker_stability(NeoHookean{Lame{mu, bulk}}, 0.1, 10).stable);
    EXPECT_TRUE(drucker_stability(mooney_rivlin(1.6e6, 0.4e6, bulk), 0.1, 10).stable);
    EXPECT_TRUE(drucker_stability(two_terms(bulk), 0.1, 10).stable);
    // c01 < 0 gives way where one side is thin: in equal biaxial tension I2 takes over
    const StabilityReport report = drucker_stability(mooney_rivlin(2.4e6, -0.4e6, bulk), 0.5, 4);
    EXPECT_FALSE(report.stable);
    EXPECT_NE(report.text.find("equibiaxial from "), std::string::npos) << report.text;
    EXPECT_NE(report.text.find(" up"), std::string::npos) << report.text;
    const auto falling =
        std::make_shared<UniaxialCurve>(std::vector<double>{0.2, 0.4, 0.6}, std::vector<double>{1e6, 1.1e6, 0.7e6});
    EXPECT_FALSE(drucker_stability(Marlow{{falling}, bulk}, 0.9, 2).stable);
}

} // namespace

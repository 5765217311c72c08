// SPDX-License-Identifier: MIT
#include "coupler_lib/base/ground.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

using namespace base;

/// gap_slope and normal_slope against difference quotients.
void expect_exact_derivatives(const Ground& ground, const Eigen::Vector3d& x, int dimension, double tolerance)
{
    const double h = 1e-6;
    const GroundPoint here = ground.at(x);
    EXPECT_NEAR(here.normal.norm(), 1, 1e-14);
    for (int k = 0; k < dimension; ++k) {
        const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(k);
        const GroundPoint up = ground.at(x + step), down = ground.at(x - step);
        EXPECT_NEAR(here.gap_slope[k], (up.gap - down.gap) / (2 * h), tolerance);
        EXPECT_LT((here.normal_slope.col(k) - (up.normal - down.normal) / (2 * h)).norm(), 100 * tolerance);
    }
}

TEST(Ground, PlaneIsTheDistance)
{
    const auto plane = make_plane({0, 1, 0}, {3, 4, 0});
    EXPECT_NEAR(plane->at({3, 5, 0}).gap, 5, 1e-14);
    expect_exact_derivatives(*plane, {0.3, -0.2, 0}, 2, 1e-9);
    EXPECT_THROW(make_plane({0, 0, 0}, {0, 0, 0}), Error);
}

TEST(Ground, FormulaHasExactDerivatives)
{
    const auto wave = make_height_ground(make_height_formula({"0.1*sin(3*x)"}, 2, 1e-4), 2);
    expect_exact_derivatives(*wave, {0.4, 0.13, 0}, 2, 1e-8);
    const auto hills = make_height_ground(make_height_formula({"0.1*sin(3*x)*cos(2*y)"}, 3, 1e-4), 3);
    expect_exact_derivatives(*hills, {0.4, -0.3, 0.02}, 3, 1e-8);
    EXPECT_NEAR(hills->at({0.4, -0.3, 0.1 * std::sin(1.2) * std::cos(0.6)}).gap, 0, 1e-15);
}

/// Near the surface the gap is the distance: for a sphere's cap, up to gap^2 times the curvature.
TEST(Ground, GapIsTheDistanceNearTheSurface)
{
    const auto cap = make_height_ground(make_height_formula({"sqrt(1 - x^2 - y^2)"}, 3, 1e-4), 3);
    for (const double distance : {1e-2, 1e-3}) {
        const Eigen::Vector3d x = (1 + distance) * Eigen::Vector3d(0.3, 0.2, std::sqrt(1 - 0.13));
        EXPECT_NEAR(cap->at(x).gap, distance, distance * distance);
    }
}

class HeightTable : public testing::Test {
protected:
    std::string path_ = (std::filesystem::temp_directory_path() / "rivage_heights.csv").string();

    void write(int n, const std::function<double(double, double)>& height) const
    {
        std::ofstream file(path_);
        file << "x[m],y[m],height[m]\n";
        file.precision(17);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double x = i / (n - 1.0), y = 2.0 * j / (n - 1.0);
                file << x << ',' << y << ',' << height(x, y) << '\n';
            }
    }
    void TearDown() override { std::filesystem::remove(path_); }
};

TEST_F(HeightTable, MeetsItsPointsAndIsOfThirdOrder)
{
    const auto height = [](double x, double y) { return 0.1 * std::sin(3 * x + 1) * std::cos(2 * y); };
    double last = 0;
    for (const int n : {11, 21, 41}) {
        write(n, height);
        const auto field = make_height_table(path_, 3);
        EXPECT_NEAR(field->at(0.3, 0.8).value, height(0.3, 0.8), 1e-15);
        double worst = 0;
        for (double x = 0.21; x < 0.8; x += 0.0173)
            for (double y = 0.41; y < 1.6; y += 0.0371)
                worst = std::max(worst, std::abs(field->at(x, y).value - height(x, y)));
        if (last > 0) {
            EXPECT_LT(worst, last / 6);
        }
        last = worst;
    }
    expect_exact_derivatives(*make_height_ground(make_height_table(path_, 3), 3), {0.333, 0.777, 0.05}, 3, 1e-6);
}

TEST_F(HeightTable, NamesAPlaceWithoutHeight)
{
    std::ofstream(path_) << "x[m],y[m],height[m]\n0,0,1\n1,0,1\n0,1,1\n0,1,2\n";
    EXPECT_THROW(make_height_table(path_, 3), Error);
    std::ofstream(path_) << "x[m],height[m]\n0,1\n1,1\n3,1\n";
    EXPECT_THROW(make_height_table(path_, 2), Error);
}

TEST(HeightFile, OfAFormulaIsTheFormula)
{
    const std::string path = (std::filesystem::temp_directory_path() / "rivage_height.toml").string();
    std::ofstream(path) << "height = \"0.1*sin(3*x)*cos(2*y)\"\nderivative_step = 1e-4\n";
    const auto height = make_height_file(path, 3);
    EXPECT_DOUBLE_EQ(height->at(0.4, -0.3).value, 0.1 * std::sin(1.2) * std::cos(0.6));
    EXPECT_NEAR(height->at(0.4, -0.3).slope[0], 0.3 * std::cos(1.2) * std::cos(0.6), 1e-10);
    std::ofstream(path) << "heights = \"x\"\n";
    EXPECT_THROW(make_height_file(path, 3), Error);
    std::filesystem::remove(path);
}

} // namespace

// SPDX-License-Identifier: MIT
// Water and wall of a rough ground stand on the heights of one file, which a solid's contact reads too.
#include "coupler_lib/base/ground.hpp"
#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/config/wall_config.hpp"
#include "sph_solver/setup/water_body.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace sph {
namespace {

class GroundFile : public testing::Test {
protected:
    std::string path_ = (std::filesystem::temp_directory_path() / "rivage_ground.toml").string();

    void SetUp() override { std::ofstream(path_) << "height = \"0.1*cos(x) + 0.05*sin(2*y)\"\n"; }
    void TearDown() override { std::filesystem::remove(path_); }
    static double height(double x, double y) { return 0.1 * std::cos(x) + 0.05 * std::sin(2 * y); }
    WallConfig wall() const
    {
        WallConfig wall;
        wall.name = "road";
        wall.shape = "ground";
        wall.file = path_;
        wall.low = {-1, 0};
        wall.high = {1, 3};
        wall.size = 0.25;
        return wall;
    }
    WaterConfig film() const { return {.shape = "film", .low = {-1, 0, -1}, .high = {1, 3, 0.5}, .file = path_}; }
};

TEST_F(GroundFile, WallHasItsCornersOnTheGroundAndItsNormalsUp)
{
    const WallShape shape = wall_shape(wall(), 3);
    EXPECT_EQ(shape.facets.size(), 8u * 12u);
    const auto corner = [&](int v) {
        return Eigen::Map<const Vec<3>>(&shape.vertices[3 * static_cast<std::size_t>(v)]);
    };
    double area = 0;
    for (const auto& facet : shape.facets) {
        for (const int v : facet) EXPECT_NEAR(corner(v).z(), height(corner(v).x(), corner(v).y()), 1e-15);
        const Vec<3> normal = 0.5 * (corner(facet[2]) - corner(facet[0])).cross(corner(facet[3]) - corner(facet[1]));
        EXPECT_GT(normal.z(), 0);
        area += normal.z();
    }
    EXPECT_NEAR(area, 6, 1e-12);
}

TEST_F(GroundFile, WallInThePlaneHasTheSolidBelow)
{
    std::ofstream(path_) << "height = \"0.1*x\"\n";
    WallConfig line = wall();
    line.low = {-1};
    line.high = {1};
    const WallShape shape = wall_shape(line, 2);
    ASSERT_EQ(shape.facets.size(), 8u);
    for (const auto& facet : shape.facets)
        EXPECT_LT(shape.vertices[2 * static_cast<std::size_t>(facet[1])],
                  shape.vertices[2 * static_cast<std::size_t>(facet[0])]);
}

TEST_F(GroundFile, FilmFillsTheSpaceBetweenGroundAndLevel)
{
    const auto water = make_water_body<3>(film(), 0.1);
    double volume = 0;
    for (std::int64_t k = 0; k < water->count(); ++k) {
        const auto point = water->point(k);
        EXPECT_TRUE(water->contains(point.position));
        EXPECT_NEAR(point.volume, 1e-3, 0.2e-3);
        volume += point.volume;
    }
    // The integral of 0.5 - height over 2 x 3 m; the middles of columns err by their curvature.
    const double exact = 3.0 - 3 * 0.2 * std::sin(1) - 2 * 0.025 * (1 - std::cos(6));
    EXPECT_NEAR(volume, exact, 1e-3 * exact);
}

TEST_F(GroundFile, ColumnsOfLessThanHalfASpacingStayDry)
{
    WaterConfig puddle = film();
    puddle.high[2] = 0.04; // the crests are higher
    const auto water = make_water_body<3>(puddle, 0.02);
    for (std::int64_t k = 0; k < water->count(); ++k) EXPECT_GE(water->point(k).volume, 0.5 * 8e-6);
    puddle.high[2] = -0.2;
    EXPECT_THROW(make_water_body<3>(puddle, 0.02), base::Error);
}

TEST_F(GroundFile, SaysWhatAWallLacks)
{
    WallConfig bad = wall();
    bad.size = 0;
    EXPECT_THROW(wall_shape(bad, 3), base::Error);
    bad = wall();
    bad.high = {1};
    EXPECT_THROW(wall_shape(bad, 3), base::Error);
    std::ofstream(path_) << "hight = \"x\"\n";
    EXPECT_THROW(wall_shape(wall(), 3), base::Error);
}

} // namespace
} // namespace sph

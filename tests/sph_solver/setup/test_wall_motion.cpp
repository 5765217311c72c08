// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/setup/wall_motion.hpp"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

namespace sph {
namespace {

const MotionSpan span{0, 1, 2e-5};

std::string wall_refusal(const WallConfig& wall, int dimension = 2)
{
    try {
        check_motion(wall, dimension);
        make_motion<2>(wall, span);
    } catch (const base::Error& error) {
        return error.what();
    }
    return "";
}

TEST(WallMotion, OfAFormulaHasItsDerivatives)
{
    WallConfig wall{.name = "piston"};
    wall.motion.translation = {{"0.005*(1 - cos(4*pi*t))", ""}, {"0", ""}};
    const auto place = make_motion<2>(wall, span).at(0.1);
    const double omega = 4 * std::acos(-1.0);
    EXPECT_NEAR(place.displacement.x(), 0.005 * (1 - std::cos(0.1 * omega)), 1e-16);
    EXPECT_NEAR(place.velocity.x(), 0.005 * omega * std::sin(0.1 * omega), 1e-12);
    EXPECT_NEAR(place.acceleration.x(), 0.005 * omega * omega * std::cos(0.1 * omega), 1e-7);
    EXPECT_EQ(place.velocity.y(), 0);
}

TEST(WallMotion, OfATableGoesThroughItAndMustCoverTheRun)
{
    const std::string path = testing::TempDir() + "sway.csv";
    std::ofstream(path) << "t[s],x[m],y[m]\n0,0,0\n0.5,0.01,0.02\n1.5,0.03,0\n";
    WallConfig wall{.name = "tank"};
    wall.motion.table = path;
    const auto motion = make_motion<2>(wall, span);
    EXPECT_NEAR(motion.at(0.5).displacement.y(), 0.02, 1e-16);
    EXPECT_NE(motion.at(0.5).acceleration.y(), 0);
    std::ofstream(path) << "t[s],x[m],y[m]\n0,0,0\n0.5,0.01,0.02\n";
    EXPECT_NE(wall_refusal(wall).find("the run goes from 0 s to 1 s"), std::string::npos);
}

TEST(WallMotion, RefusesWhatContradictsItself)
{
    WallConfig wall{.name = "piston"};
    wall.motion.translation = {{"t", ""}};
    EXPECT_NE(wall_refusal(wall).find("1 formulas, 2 are needed"), std::string::npos);
    wall.motion.translation = {{"t", ""}, {"speed*t", "fluid.toml:7"}};
    EXPECT_NE(wall_refusal(wall).find("fluid.toml:7"), std::string::npos);
    wall.motion.translation = {};
    wall.motion.rotation = {"t", ""};
    EXPECT_NE(wall_refusal(wall).find("motion.centre"), std::string::npos);
    wall.motion.centre = {0, 0};
    EXPECT_EQ(wall_refusal(wall), "");
    wall.motion.axis = {1, 0, 0};
    EXPECT_NE(wall_refusal(wall).find("about the z axis"), std::string::npos);
}

} // namespace
} // namespace sph

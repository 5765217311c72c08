// SPDX-License-Identifier: MIT
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;

TEST(PairFilter, NobodySeesThroughAPlate)
{
    auto walls = lines({{Vec<2>(0, 9), Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(1, 9)}});
    walls.prepare(particles_at<2>({Vec<2>(-0.5, 3)}), 0.1);
    EXPECT_FALSE(walls.may_interact({-0.5, 3}, {1.5, 3}));
    EXPECT_FALSE(walls.may_interact({1.5, 3}, {-0.5, 3}));
    EXPECT_TRUE(walls.may_interact({-0.5, 3}, {-0.4, 4}));
    EXPECT_TRUE(walls.may_interact({-0.5, -0.2}, {1.5, -0.2})); // below the tip
    EXPECT_TRUE(walls.may_interact({-0.3, 0.2}, {0.3, -0.3}));  // around the tip's corner
}

TEST(PairFilter, AParticleStuckInAPlateSeesItsOwnSide)
{
    auto walls = lines({{Vec<2>(0, 9), Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(1, 9)}});
    walls.prepare(particles_at<2>({Vec<2>(-0.5, 3)}), 0.1);
    EXPECT_TRUE(walls.may_interact({0.1, 3}, {-0.5, 3}));
    EXPECT_FALSE(walls.may_interact({0.1, 3}, {1.5, 3}));
    EXPECT_FALSE(walls.may_interact({1.5, 3}, {0.1, 3}));
}

TEST(PairFilter, PlateWithoutThickness)
{
    auto walls = lines({{Vec<2>(0, 9), Vec<2>(0, 0), Vec<2>(0, 9)}});
    walls.prepare(particles_at<2>({Vec<2>(-0.5, 3)}), 0.1);
    EXPECT_FALSE(walls.may_interact({-0.5, 3}, {0.5, 3.1}));
    EXPECT_TRUE(walls.may_interact({-0.5, -0.3}, {0.5, -0.1}));
}

} // namespace
} // namespace sph

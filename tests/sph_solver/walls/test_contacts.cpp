// SPDX-License-Identifier: MIT
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;

TEST(Contacts, FarFromWallsThereAreNone)
{
    auto walls = lines({{Vec<2>(9, 0), Vec<2>(-9, 0)}});
    EXPECT_TRUE(planes_at<2>(walls, {0, 3}).empty());
    EXPECT_EQ(planes_at<2>(walls, {0, 2}).size(), 1u);
}

TEST(Contacts, FlushJointOfTwoBodiesIsOneSheet)
{
    auto walls = lines({{Vec<2>(9, 0), Vec<2>(0, 0)}, {Vec<2>(0, 0), Vec<2>(-9, 0)}});
    const auto planes = planes_at<2>(walls, {0.3, 0.5});
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_EQ(planes[0].cuts.size(), 0u);
    EXPECT_NEAR(planes[0].normal.y(), 1, 1e-12);
    EXPECT_NEAR(planes[0].distance, 0.5, 1e-12);
}

TEST(Contacts, FlushWallWithAFaceAgainstTheGateCutsNothing)
{
    // the wall above the gate is drawn all round: its lower face lies on the gate's upper end
    auto walls = lines({{Vec<2>(0, 9), Vec<2>(0, 0), Vec<2>(5, 0), Vec<2>(5, 9)}, {Vec<2>(0, 0), Vec<2>(0, -9)}});
    for (const double y : {-1.0, -0.2, 0.2, 1.0}) {
        const auto planes = planes_at<2>(walls, {-0.5, y});
        ASSERT_EQ(planes.size(), 1u) << y;
        EXPECT_EQ(planes[0].cuts.size(), 0u) << y;
        EXPECT_NEAR(planes[0].normal.x(), -1, 1e-12);
    }
}

TEST(Contacts, ConvexEdgeHasOnePlaneTowardsTheParticle)
{
    auto walls = lines({{Vec<2>(0, 9), Vec<2>(0, 0), Vec<2>(9, 0)}});
    const auto planes = planes_at<2>(walls, {-0.3, -0.4});
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_NEAR(planes[0].normal.x(), -0.6, 1e-12);
    EXPECT_NEAR(planes[0].normal.y(), -0.8, 1e-12);
    EXPECT_EQ(planes[0].cuts.size(), 2u);
}

TEST(Contacts, ConcaveCornersHaveAPlaneForEachSheet)
{
    auto walls = lines({{Vec<2>(9, 0), Vec<2>(0, 0), Vec<2>(0, 9)}});
    EXPECT_EQ(planes_at<2>(walls, {0.5, 0.7}).size(), 2u);
    auto box = cube_walls(10);
    EXPECT_EQ(planes_at<3>(box, {0.5, 0.7, 0.6}).size(), 3u);
    EXPECT_EQ(planes_at<3>(box, {0.5, 0.7, 5}).size(), 2u);
    EXPECT_EQ(planes_at<3>(box, {5, 5, 9.5}).size(), 1u);
}

TEST(Contacts, PlateTipOverFloorHasBoth)
{
    auto walls = lines({{Vec<2>(0, 9), Vec<2>(0, 2), Vec<2>(5, 2), Vec<2>(5, 9)}, {Vec<2>(20, 0), Vec<2>(-20, 0)}});
    EXPECT_EQ(planes_at<2>(walls, {2.5, 1}).size(), 2u);
    EXPECT_EQ(planes_at<2>(walls, {-0.5, 1}).size(), 2u);
    EXPECT_EQ(planes_at<2>(walls, {-0.5, 5}).size(), 1u);
}

TEST(Contacts, GateCornerThatDipsIntoTheFloorChangesNothing)
{
    const std::vector<Vec<2>> floor{Vec<2>(20, 0), Vec<2>(-20, 0)};
    auto flush = lines({{Vec<2>(0, 9), Vec<2>(0, 0), Vec<2>(5, 0), Vec<2>(5, 9)}, floor});
    auto dipped = lines({{Vec<2>(0, 9), Vec<2>(0, -0.06), Vec<2>(5, -0.04), Vec<2>(5, 9)}, floor});
    const auto is_fluid = [](const Vec<2>& x) { return x.x() < 0 && x.y() > 0; };
    for (const Vec<2>& x : {Vec<2>(-0.5, 0.5), Vec<2>(-0.2, 0.3), Vec<2>(-1.5, 0.5), Vec<2>(-0.5, 2)}) {
        EXPECT_EQ(planes_at<2>(dipped, x).size(), 2u);
        EXPECT_NEAR(look_around(flush, x, is_fluid).volume, 1, 0.01);
        EXPECT_NEAR(look_around(dipped, x, is_fluid).volume, 1, 0.01);
    }
}

TEST(Contacts, ParticleInsideIsSentOutOfTheNearestFace)
{
    auto walls = lines({{Vec<2>(0, 9), Vec<2>(0, 0), Vec<2>(5, 0), Vec<2>(5, 9)}});
    const auto planes = planes_at<2>(walls, {0.1, 4});
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_NEAR(planes[0].distance, -0.1, 1e-12);
    EXPECT_NEAR(planes[0].normal.x(), -1, 1e-12);
    const auto report = walls.penetration();
    EXPECT_EQ(report.count, 1);
    EXPECT_NEAR(report.deepest, 0.1, 1e-12);
}

TEST(Contacts, BeyondTheEndOfAWallNobodyIsInside)
{
    auto walls = lines({{Vec<2>(0, 0), Vec<2>(-20, 0)}});
    const auto planes = planes_at<2>(walls, {0.3, -0.4});
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_NEAR(planes[0].normal.y(), -0.8, 1e-12);
    EXPECT_GT(planes[0].distance, 0);
    EXPECT_EQ(walls.penetration().count, 0);
}

TEST(Contacts, MovingFacetsCarryVelocityAndAcceleration)
{
    Walls<2> walls(unit_settings<2>());
    VertexMotion<2> motion;
    motion.position = {Vec<2>(4, 0), Vec<2>(-4, 0)};
    motion.velocity = {Vec<2>(0, 1), Vec<2>(0, 3)};
    motion.acceleration = {Vec<2>(0, 2), Vec<2>(0, 2)};
    WallFacet<2> facet;
    facet.vertex = {0, 1};
    walls.set_moving({"plate"}, motion, {facet});
    walls.move(0.1);
    const auto planes = planes_at<2>(walls, {0, 1});
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_NEAR(planes[0].velocity.y(), 2.2, 1e-2); // shape functions at x_w, which the slope moves a little
    EXPECT_NEAR(planes[0].acceleration.y(), 2, 1e-12);
    EXPECT_NEAR(walls.facets().positions()[1].y(), 0.31, 1e-12);
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;
using base::TimeValue;

/// A pendulum's swing beside a drift; derivatives by hand.
template<int D> RigidMotion<D> swing()
{
    RigidMotion<D> motion;
    motion.translation[0] = [](double t) { return TimeValue{0.5 * t * t, t, 1.0}; };
    motion.rotation = [](double t) {
        return TimeValue{0.3 * std::sin(2 * t), 0.6 * std::cos(2 * t), -1.2 * std::sin(2 * t)};
    };
    motion.centre = Vec<D>::Constant(0.7);
    motion.axis = Vec<3>(1, 2, 2) / 3;
    return motion;
}

template<int D> void expect_consistent_derivatives()
{
    const auto motion = swing<D>();
    Vec<D> x = Vec<D>::Constant(2);
    x[0] = -1;
    const double t = 0.4, h = 1e-5;
    const auto before = motion.at(t - h), here = motion.at(t), after = motion.at(t + h);
    EXPECT_LT(((after.position(x) - before.position(x)) / (2 * h) - here.velocity_of(x)).norm(), 1e-9);
    EXPECT_LT(((after.velocity_of(x) - before.velocity_of(x)) / (2 * h) - here.acceleration_of(x)).norm(), 1e-9);
    EXPECT_NEAR((here.turn * here.turn.transpose() - Mat<D>::Identity()).norm(), 0, 1e-14); // rigid
    const Vec<D> centre_moves = here.position(motion.centre) - motion.centre;
    EXPECT_NEAR((centre_moves - 0.5 * t * t * Vec<D>::Unit(0)).norm(), 0, 1e-15);
}

TEST(RigidMotion, VelocityAndAccelerationAreTheDerivativesOfThePosition)
{
    expect_consistent_derivatives<2>();
    expect_consistent_derivatives<3>();
}

TEST(RigidMotion, TurnsCounterclockwise)
{
    RigidMotion<2> motion;
    motion.rotation = [](double) { return TimeValue{std::numbers::pi / 2, 1, 0}; };
    const auto place = motion.at(0);
    EXPECT_NEAR((place.position({1, 0}) - Vec<2>(0, 1)).norm(), 0, 1e-15);
    EXPECT_NEAR((place.velocity_of({1, 0}) - Vec<2>(-1, 0)).norm(), 0, 1e-15);
}

TEST(DrivenWalls, AreWhereTheirMotionSaysAtEveryInstantOfAStep)
{
    Walls<2> walls(unit_settings<2>());
    RigidMotion<2> motion;
    motion.translation[1] = [](double t) { return TimeValue{t * t * t, 3 * t * t, 6 * t}; };
    walls.add_fixed({"floor"}, {4, -9, -4, -9}, {{0, 1, -1, -1}});
    walls.add_driven({"lid"}, {4, 0, -4, 0}, {{0, 1, -1, -1}}, motion);
    walls.start_step(0.5);
    walls.move(0.1);
    const auto planes = planes_at<2>(walls, {0, 1});
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_NEAR(planes[0].point.y(), 0.216, 1e-15);
    EXPECT_NEAR(planes[0].velocity.y(), 1.08, 1e-14);
    EXPECT_NEAR(planes[0].acceleration.y(), 3.6, 1e-14);
    EXPECT_FALSE(walls.facets().is_wet(planes[0].facet));  // its work is that of the walls, not of the interface
    EXPECT_NEAR(walls.facets().positions()[0].y(), -9, 0); // the floor stands still
    walls.move(0.2);
    EXPECT_NEAR(walls.largest_displacement(), 0.343 - 0.216, 1e-14);
}

TEST(DrivenWalls, EachWallSlipsOrNot)
{
    Walls<2> walls(unit_settings<2>());
    walls.add_fixed({"smooth"}, {4, 0, -4, 0}, {{0, 1, -1, -1}});
    walls.add_fixed({"rough", true}, {-4, 3, 4, 3}, {{0, 1, -1, -1}});
    const auto planes = planes_at<2>(walls, {0, 1.4});
    ASSERT_EQ(planes.size(), 2u);
    EXPECT_FALSE(planes[0].no_slip);
    EXPECT_TRUE(planes[1].no_slip);
}

} // namespace
} // namespace sph

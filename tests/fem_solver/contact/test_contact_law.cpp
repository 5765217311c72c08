// SPDX-License-Identifier: MIT
#include "fem_solver/contact/contact_law.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;

const ContactConstants rubber_on_rock{2e6, 1e6, 0.4};

/// The state of a point over hills, with the way it has gone since the last step.
struct Place {
    std::unique_ptr<base::Ground> ground =
        base::make_height_ground(base::make_height_formula({"0.1*sin(3*x)*cos(2*y)"}, 3, 1e-4), 3);
    Eigen::Vector3d start{0.4, -0.3, 0.06};
    Multipliers multipliers{3e4, {100, -200, 50}};

    ContactTraction at(const Eigen::Vector3d& x) const
    {
        return contact_traction(ground->at(x), multipliers, x - start, rubber_on_rock);
    }
    Eigen::Vector3d total(const Eigen::Vector3d& x) const
    {
        const ContactTraction traction = at(x);
        return traction.pressure * ground->at(x).normal + traction.friction;
    }
};

void expect_consistent_slope(const Place& place, const Eigen::Vector3d& x, bool sticks)
{
    const ContactTraction traction = place.at(x);
    ASSERT_TRUE(traction.touches);
    EXPECT_EQ(traction.sticks, sticks);
    const double h = 1e-7;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(k);
        const Eigen::Vector3d quotient = (place.total(x + step) - place.total(x - step)) / (2 * h);
        EXPECT_LT((traction.slope.col(k) - quotient).norm(), 1e-6 * traction.slope.norm()) << k;
    }
}

TEST(ContactLaw, SlopeIsTheDifferenceQuotient)
{
    const Place place;
    expect_consistent_slope(place, {0.401, -0.299, 0.07}, true);
    expect_consistent_slope(place, {0.45, -0.27, 0.07}, false);
}

TEST(ContactLaw, FrictionStaysInItsCone)
{
    const Place place;
    for (double way = 0; way < 0.1; way += 0.002) {
        const Eigen::Vector3d x = place.start + Eigen::Vector3d(way, -0.5 * way, 0.005);
        const ContactTraction traction = place.at(x);
        EXPECT_LE(traction.friction.norm(), rubber_on_rock.friction * traction.pressure * (1 + 1e-14));
        EXPECT_NEAR(traction.friction.dot(place.ground->at(x).normal), 0, 1e-10 * traction.pressure);
    }
}

TEST(ContactLaw, OpenContactPullsNothing)
{
    const Place place;
    const ContactTraction traction = place.at({0.4, -0.3, 0.3});
    EXPECT_FALSE(traction.touches);
    EXPECT_EQ(traction.pressure, 0);
    EXPECT_EQ(traction.friction.norm() + traction.slope.norm(), 0);
}

/// Slipping works against the motion: -tau . d > 0.
TEST(ContactLaw, SlipDissipates)
{
    Place place;
    place.multipliers.traction.setZero();
    const Eigen::Vector3d way(0.05, 0.03, 0);
    const ContactTraction traction = place.at(place.start + way);
    EXPECT_LT(traction.friction.dot(way), 0);
}

} // namespace

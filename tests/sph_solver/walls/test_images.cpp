// SPDX-License-Identifier: MIT
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;

/// A wall that turns at the origin, with the fluid in the sector from 0 to `inner` degrees.
struct Sector {
    double inner;
    Walls<2> walls;
    explicit Sector(double degrees) : inner(degrees), walls(lines({{polar(30, 0), Vec<2>(0, 0), polar(30, degrees)}}))
    {}

    bool holds(const Vec<2>& x) const
    {
        double angle = std::atan2(x.y(), x.x()) * 180 / std::numbers::pi;
        if (angle < 0) angle += 360;
        return angle > 0 && angle < inner;
    }
    Seen look(const Vec<2>& x)
    {
        return look_around(walls, x, [this](const Vec<2>& y) { return holds(y); });
    }
};

TEST(Images, FillASpaceOnceInConcaveCornersOfAnyAngle)
{
    for (const double inner : {180.0, 172.0, 160.0, 140.0, 120.0, 100.0, 90.0, 75.0, 60.0}) {
        Sector sector(inner);
        const double limit = 0.035; // the fine lattice's staircase
        for (const double r : {0.6, 1.2, 2.2})
            for (const double part : {0.2, 0.35, 0.5, 0.8}) {
                const Seen seen = sector.look(polar(r, part * inner));
                EXPECT_NEAR(seen.volume, 1, limit) << inner << " degrees, r " << r << ", part " << part;
                EXPECT_LT(seen.gradient.norm(), 0.03) << inner << " degrees, r " << r << ", part " << part;
            }
    }
}

TEST(Images, DoNotOverlapWithTheFluidAroundConvexEdges)
{
    for (const double inner : {182.0, 190.0, 225.0, 270.0}) {
        Sector sector(inner);
        for (const double r : {0.5, 1.2, 2.2})
            for (const double part : {0.1, 0.3, 0.5, 0.7}) {
                const Seen seen = sector.look(polar(r, part * inner));
                EXPECT_NEAR(seen.volume, 1, 0.01) << inner << " degrees, r " << r << ", part " << part;
                EXPECT_LT(seen.gradient.norm(), 0.015) << inner << " degrees, r " << r << ", part " << part;
            }
    }
}

TEST(Images, FillASpaceOnceAlongFans)
{
    // facets of 5, 8 and 12 degrees that turn by 60 degrees in all, hollow and bulging
    for (const double turn : {5.0, 8.0, 12.0, -5.0, -8.0, -12.0}) {
        const double length = 1.5 * std::abs(turn) / 8;
        std::vector<Vec<2>> points{Vec<2>(20, 0), Vec<2>(0, 0)};
        double heading = 180; // the solid is on the left; a hollow turns to the right
        for (double turned = 0; turned < 60; turned += std::abs(turn)) {
            heading -= turn;
            points.push_back(points.back() + polar(length, heading));
        }
        points.back() += polar(20, heading);
        auto walls = lines({points});
        const auto is_fluid = [&](const Vec<2>& x) { // in front of all facets of a hollow, of any facet of a bulge
            bool all = true, any = false;
            for (std::size_t k = 0; k + 1 < points.size(); ++k) {
                const bool front =
                    (x - points[k]).dot(base::area_vector(base::Simplex<2>{points[k], points[k + 1]})) > 0;
                all = all && front;
                any = any || front;
            }
            return turn > 0 ? all : any;
        };
        for (std::size_t k = 1; k + 2 < points.size(); ++k)
            for (const double height : {0.5, 1.0, 1.8}) {
                const Vec<2> normal = base::area_vector(base::Simplex<2>{points[k], points[k + 1]}).normalized();
                const Vec<2> x = points[k] + 0.3 * (points[k + 1] - points[k]).normalized() + height * normal;
                const Seen seen = look_around(walls, x, is_fluid);
                EXPECT_NEAR(seen.volume, 1, 0.01) << turn << " degrees, facet " << k << ", height " << height;
                EXPECT_LT(seen.gradient.norm(), 0.015) << turn << " degrees, facet " << k << ", height " << height;
            }
    }
}

TEST(Images, FillWhatAThinPlateOrASharpWedgeHides)
{
    // what the particle sees past the edge is fluid, what it does not see is filled with images
    for (const double inner : {300.0, 315.0, 330.0, 345.0}) {
        Sector wedge(inner);
        for (const double r : {0.5, 1.2, 2.2})
            for (const double part : {0.1, 0.2, 0.35, 0.5}) {
                const Vec<2> x = polar(r, part * inner);
                wedge.walls.prepare(particles_at<2>({x}), 0.1);
                const auto sees = [&](const Vec<2>& y) { return wedge.holds(y) && wedge.walls.may_interact(x, y); };
                const Seen seen = look_around<2>(wedge.walls, x, sees);
                EXPECT_NEAR(seen.volume, 1, 0.03) << inner << " degrees, r " << r << ", part " << part;
                EXPECT_LT(seen.gradient.norm(), 0.07) << inner << " degrees, r " << r << ", part " << part;
            }
    }
    auto plate = lines({{Vec<2>(0, 9), Vec<2>(0, 0), Vec<2>(0, 9)}}); // no thickness
    for (const double y : {-1.0, -0.5, -0.2, 0.2, 0.5, 1.0, 2.0})
        for (const double x : {-1.5, -0.5, 0.5}) {
            const Vec<2> at(x, y);
            plate.prepare(particles_at<2>({at}), 0.1);
            const Seen seen = look_around<2>(plate, at, [&](const Vec<2>& p) { return plate.may_interact(at, p); });
            EXPECT_NEAR(seen.volume, 1, 0.02) << x << " " << y;
            EXPECT_LT(seen.gradient.norm(), 0.06) << x << " " << y;
        }
}

/// Largest change of the images' volume along a way in steps of 1/50 dx.
double largest_jump(Walls<2>& walls, const std::function<bool(const Vec<2>&)>& is_fluid, const Vec<2>& from,
                    const Vec<2>& to)
{
    const int steps = static_cast<int>(std::ceil((to - from).norm() / 0.02));
    double jump = 0, last = look_around(walls, from, is_fluid, 0.1).volume;
    for (int s = 1; s <= steps; ++s) {
        const Vec<2> x = from + (static_cast<double>(s) / steps) * (to - from);
        const double volume = look_around(walls, x, is_fluid, 0.1).volume;
        jump = std::max(jump, std::abs(volume - last));
        last = volume;
    }
    return jump;
}

TEST(Images, VolumeIsContinuousAroundAConvexEdge)
{
    Sector edge(270);
    const auto is_fluid = [&](const Vec<2>& x) { return edge.holds(x); };
    EXPECT_LT(largest_jump(edge.walls, is_fluid, {2, 0.5}, {-0.6, 0.5}), 0.02);
    EXPECT_LT(largest_jump(edge.walls, is_fluid, {-0.5, 0.6}, {-0.5, -2}), 0.02);
}

TEST(Images, VolumeIsContinuousOverAJointAndInAConcaveCorner)
{
    auto joint = lines({{Vec<2>(9, 0), Vec<2>(0.013, 0)}, {Vec<2>(0, 0), Vec<2>(-9, 0)}});
    const auto above = [](const Vec<2>& x) { return x.y() > 0; };
    EXPECT_LT(largest_jump(joint, above, {1, 0.5}, {-1, 0.5}), 1e-2);
    Sector corner(90);
    const auto in_corner = [&](const Vec<2>& x) { return corner.holds(x); };
    EXPECT_LT(largest_jump(corner.walls, in_corner, {3, 0.5}, {0.3, 0.5}), 1e-2);
    Sector wide(140);
    const auto in_wide = [&](const Vec<2>& x) { return wide.holds(x); };
    EXPECT_LT(largest_jump(wide.walls, in_wide, polar(1, 20), polar(1, 120)), 0.02);
}

TEST(Images, VolumeIsContinuousUnderAPlateTip)
{
    auto walls = lines({{Vec<2>(0, 9), Vec<2>(0, 2.5), Vec<2>(5, 2.5), Vec<2>(5, 9)}, {Vec<2>(20, 0), Vec<2>(-20, 0)}});
    const auto is_fluid = [](const Vec<2>& x) { return x.y() > 0 && (x.y() < 2.5 || x.x() < 0 || x.x() > 5); };
    EXPECT_LT(largest_jump(walls, is_fluid, {-1, 1.2}, {2, 1.2}), 0.02);
    EXPECT_LT(largest_jump(walls, is_fluid, {-0.5, 4}, {-0.5, 0.5}), 0.02);
    EXPECT_NEAR(look_around(walls, {2.5, 1.2}, is_fluid).volume, 1, 1e-2);
}

TEST(Images, OwnImageStaysAway)
{
    auto walls = lines({{Vec<2>(9, 0), Vec<2>(-9, 0)}});
    const std::vector<Vec<2>> positions{Vec<2>(0, 0.01)};
    const auto particles = particles_at<2>(positions);
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);
    int count = 0;
    ImageFinder<2>(walls.settings())
        .for_each(walls.contacts().contacts[0], walls.contacts().planes, positions, {}, [&](const Image<2>& image) {
            ++count;
            EXPECT_NEAR(std::sqrt(image.squared_distance), walls.settings().image_distance, 1e-12);
        });
    EXPECT_EQ(count, 1);
}

TEST(Images, CornerOfThreeWallsHasSevenImagesOfAParticle)
{
    auto box = cube_walls(10);
    const std::vector<Vec<3>> positions{Vec<3>(0.5, 0.6, 0.7)};
    const auto particles = particles_at<3>(positions);
    box.prepare(particles, 0.1);
    box.find_contacts(particles);
    double weight = 0;
    ImageFinder<3>(box.settings())
        .for_each(box.contacts().contacts[0], box.contacts().planes, positions, {},
                  [&](const Image<3>& image) { weight += image.weight; });
    EXPECT_NEAR(weight, 7, 0.35); // the shares of the image in three planes add up to 1 but where two of them blend
}

} // namespace
} // namespace sph

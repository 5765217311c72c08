// SPDX-License-Identifier: MIT
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;

/// A moving bar [0, 20] x [0, 5], its surface cut in segments of the given length; the body lies inside.
Walls<2> moving_bar(double length)
{
    std::vector<Vec<2>> points;
    const auto side = [&](const Vec<2>& from, const Vec<2>& to) {
        const int n = static_cast<int>(std::lround((to - from).norm() / length));
        for (int k = 0; k < n; ++k) points.push_back(from + (to - from) * k / n);
    };
    side({0, 0}, {20, 0});
    side({20, 0}, {20, 5});
    side({20, 5}, {0, 5});
    side({0, 5}, {0, 0});
    VertexMotion<2> motion{points, {}, {}};
    std::vector<WallFacet<2>> facets;
    const int n = static_cast<int>(points.size());
    for (int p = 0; p < n; ++p) {
        facets.push_back({{p, (p + 1) % n}, 0, p, {0, 1}});
        const Vec<2>& x = points[static_cast<std::size_t>(p)];
        motion.velocity.push_back({1 - 0.1 * x.y(), 0.1 * x.x()}); // a rigid motion: v = (1, 0) + 0.1 e_z x x
        motion.acceleration.push_back({0, 3});
    }
    Walls<2> walls(unit_settings<2>());
    walls.set_moving({"bar"}, motion, facets);
    return walls;
}

struct Touch {
    MirrorPlane<2> plane;
    std::vector<double> share; ///< of each vertex
};

Touch touch(Walls<2>& walls, const Vec<2>& x)
{
    Touch result;
    result.plane = planes_at<2>(walls, x).at(0);
    result.share.assign(walls.facets().positions().size(), 0.0);
    for (int part = result.plane.footprint_begin; part < result.plane.footprint_end; ++part) {
        const auto& [facet, weight] = walls.contacts().footprints[static_cast<std::size_t>(part)];
        for (std::size_t c = 0; c < 2; ++c)
            result.share[static_cast<std::size_t>(walls.facets()[facet].vertex[c])] += weight[c];
    }
    return result;
}

TEST(Footprint, SharesAreAWholeAndNoneIsNegative)
{
    for (const double length : {0.25, 1.0, 5.0}) {
        auto walls = moving_bar(length);
        for (const Vec<2>& x : {Vec<2>(3.3, -0.5), Vec<2>(-0.3, -0.3), Vec<2>(20.4, 2), Vec<2>(19.9, 5.2)}) {
            double sum = 0;
            for (const double share : touch(walls, x).share) {
                EXPECT_GE(share, 0);
                sum += share;
            }
            EXPECT_NEAR(sum, 1, 1e-14);
        }
    }
}

TEST(Footprint, MovesAsTheWallPointInTheMiddleOfAFace)
{
    for (const double length : {0.25, 1.0, 5.0}) {
        auto walls = moving_bar(length);
        const auto plane = touch(walls, {7.5, -0.5}).plane;
        EXPECT_NEAR(plane.velocity.x(), 1, 1e-12);
        EXPECT_NEAR(plane.velocity.y(), 0.75, 0.01); // samples dx/3 apart
        EXPECT_NEAR(plane.acceleration.y(), 3, 1e-12);
    }
}

TEST(Footprint, ChangesGraduallyAroundAnEdge)
{
    auto walls = moving_bar(0.5);
    std::vector<double> before;
    for (double path = -3; path <= 3; path += 0.02) { // along the lower face, round the corner at 0, up the left face
        const Vec<2> x = path < -0.5  ? Vec<2>(-path - 0.5, -0.4)
                         : path > 0.5 ? Vec<2>(-0.4, path - 0.5)
                                      : polar(0.4, 225 - 90 * path);
        const auto now = touch(walls, x).share;
        for (std::size_t v = 0; v < before.size(); ++v) EXPECT_NEAR(now[v], before[v], 0.05) << "path " << path;
        before = now;
    }
}

} // namespace
} // namespace sph

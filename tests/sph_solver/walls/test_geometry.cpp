// SPDX-License-Identifier: MIT
#include "coupler_lib/base/box_grid.hpp"
#include "coupler_lib/base/geometry.hpp"

#include <gtest/gtest.h>
#include <random>

namespace base {
namespace {

template<int D> Point<D> random_point(std::mt19937& random)
{
    std::uniform_real_distribution<double> number(-1, 1);
    Point<D> x;
    for (int d = 0; d < D; ++d) x[d] = number(random);
    return x;
}

TEST(Geometry, ClosestPointOfSegmentIsFootOrEnd)
{
    const Simplex<2> segment{Point<2>(0, 0), Point<2>(2, 0)};
    const auto foot = closest_point(segment, {0.5, 3});
    EXPECT_DOUBLE_EQ(foot.point.x(), 0.5);
    EXPECT_DOUBLE_EQ(foot.weight[1], 0.25);
    EXPECT_DOUBLE_EQ(foot.squared_distance, 9);
    EXPECT_DOUBLE_EQ(closest_point(segment, {-3, 4}).squared_distance, 25);
}

TEST(Geometry, ClosestPointOfTriangleIsNearerThanAnySample)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(0, 1);
    for (int repeat = 0; repeat < 200; ++repeat) {
        const Simplex<3> triangle{random_point<3>(random), random_point<3>(random), random_point<3>(random)};
        const Point<3> x = 2 * random_point<3>(random);
        const auto closest = closest_point(triangle, x);
        EXPECT_NEAR(closest.weight[0] + closest.weight[1] + closest.weight[2], 1, 1e-12);
        for (int sample = 0; sample < 100; ++sample) {
            double a = number(random), b = number(random);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            const Point<3> y = triangle[0] + a * (triangle[1] - triangle[0]) + b * (triangle[2] - triangle[0]);
            EXPECT_LE(closest.squared_distance, (x - y).squaredNorm() + 1e-12);
        }
    }
}

TEST(Geometry, NormalsPointOutOfTheBody)
{
    EXPECT_GT(area_vector(Simplex<2>{Point<2>(1, 0), Point<2>(0, 0)}).y(),
              0); // solid below a floor run through leftwards
    const Point<3> area = area_vector(Simplex<3>{Point<3>(0, 0, 0), Point<3>(1, 0, 0), Point<3>(0, 1, 0)});
    EXPECT_DOUBLE_EQ(area.z(), 0.5);
}

TEST(Geometry, CrossingIsFoundWhereItIs)
{
    const Simplex<2> segment{Point<2>(0, -1), Point<2>(0, 1)};
    EXPECT_DOUBLE_EQ((crossing_fraction<2>(segment, {-1, 0}, {3, 0})), 0.25);
    EXPECT_DOUBLE_EQ((crossing_fraction<2>(segment, {-1, 2}, {1, 2})), -1);
    const Simplex<3> triangle{Point<3>(0, 0, 0), Point<3>(1, 0, 0), Point<3>(0, 1, 0)};
    EXPECT_DOUBLE_EQ((crossing_fraction<3>(triangle, {0.2, 0.2, 1}, {0.2, 0.2, -1})), 0.5);
    EXPECT_DOUBLE_EQ((crossing_fraction<3>(triangle, {0.8, 0.8, 1}, {0.8, 0.8, -1})), -1);
}

TEST(Geometry, DistanceOfSimplices)
{
    const Simplex<3> a{Point<3>(0, 0, 0), Point<3>(1, 0, 0), Point<3>(0, 1, 0)};
    Simplex<3> b = a;
    for (auto& corner : b) corner.z() += 0.3;
    EXPECT_NEAR((simplex_distance<3>(a, b)), 0.3, 1e-12);
    const Simplex<3> through{Point<3>(0.2, 0.2, -1), Point<3>(0.2, 0.2, 1), Point<3>(5, 5, 1)};
    EXPECT_DOUBLE_EQ((simplex_distance<3>(a, through)), 0);
    EXPECT_DOUBLE_EQ((simplex_distance<2>({Point<2>(0, 0), Point<2>(1, 0)}, {Point<2>(0.5, -1), Point<2>(0.5, 1)})), 0);
}

TEST(BoxGrid, FindsEveryBoxThatHoldsThePoint)
{
    std::mt19937 random(3);
    BoxGrid<3> grid(0.3);
    std::vector<Box<3>> boxes(60);
    for (int b = 0; b < 60; ++b) {
        auto& box = boxes[static_cast<std::size_t>(b)];
        box.include(random_point<3>(random));
        box.include(random_point<3>(random));
        grid.add(b, box);
    }
    grid.build();
    for (int repeat = 0; repeat < 500; ++repeat) {
        const Point<3> x = random_point<3>(random);
        const auto found = grid.near(x);
        for (int b = 0; b < 60; ++b) {
            const auto& box = boxes[static_cast<std::size_t>(b)];
            const bool inside = (x.array() >= box.low.array()).all() && (x.array() <= box.high.array()).all();
            if (!inside) continue;
            EXPECT_TRUE(std::binary_search(found.begin(), found.end(), b));
        }
    }
    EXPECT_TRUE(grid.near({90, 0, 0}).empty());
}

} // namespace
} // namespace base

// SPDX-License-Identifier: MIT
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;

constexpr double exact = 2e-5; // what the sum over the fine lattice differs from the integral

/// Chains in the plane as walls along z, each segment `parts` quadrilaterals one behind the other.
Walls<3> extruded(const std::vector<std::vector<Vec<2>>>& chains, int parts = 3)
{
    Walls<3> walls(unit_settings<3>());
    for (const auto& chain : chains) {
        std::vector<double> x;
        std::vector<std::array<int, 4>> facets;
        const int n = static_cast<int>(chain.size());
        for (int p = 0; p <= parts; ++p)
            for (const auto& v : chain) x.insert(x.end(), {v.x(), v.y(), -8.0 + 16.0 * p / parts});
        for (int p = 0; p < parts; ++p)
            for (int a = 0; a + 1 < n; ++a)
                facets.push_back({p * n + a, p * n + a + 1, (p + 1) * n + a + 1, (p + 1) * n + a});
        walls.add_fixed({"chain"}, x, facets);
    }
    return walls;
}

Vec<3> at_middle(const Vec<2>& x) { return {x.x(), x.y(), 0.3}; }

bool in_sector(const Vec<3>& x, double inner)
{
    double angle = std::atan2(x.y(), x.x()) * 180 / std::numbers::pi;
    if (angle < 0) angle += 360;
    return angle > 0 && angle < inner;
}

TEST(Images3D, FillEdgesAsIn2D)
{
    struct Limit {
        double inner, volume, gradient;
    };
    // right angles are exact, the rest is what the lattice makes of oblique cuts (a finer one in 2D: below 0.01)
    for (const Limit& limit : {Limit{180, exact, exact},
                               {140, 0.012, 0.012},
                               {120, 0.012, 0.012},
                               {90, exact, exact},
                               {60, 0.015, 0.012},
                               {190, 0.02, 0.03},
                               {225, 0.04, 0.05},
                               {270, 0.003, 0.003}}) {
        auto walls = extruded({{polar(30, 0), Vec<2>(0, 0), polar(30, limit.inner)}});
        for (const double r : {0.6, 1.2, 2.2})
            for (const double part : {0.2, 0.35, 0.5, 0.8}) {
                const Vec<3> x = at_middle(polar(r, part * limit.inner));
                const auto seen = look_around<3>(walls, x, [&](const Vec<3>& y) { return in_sector(y, limit.inner); });
                EXPECT_NEAR(seen.volume, 1, limit.volume) << limit.inner << " degrees, r " << r << ", part " << part;
                EXPECT_LT(seen.gradient.norm(), limit.gradient) << limit.inner << " degrees, r " << r;
            }
    }
}

/// A cube from 0 to 12 with the fluid inside or outside.
Walls<3> cube(bool fluid_inside)
{
    std::vector<std::array<int, 4>> faces = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                             {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    if (!fluid_inside)
        for (auto& face : faces) std::swap(face[1], face[3]);
    std::vector<double> corners;
    for (int v = 0; v < 8; ++v)
        for (int d = 0; d < 3; ++d) corners.push_back((v >> d & 1) != 0 ? 12.0 : 0.0);
    Walls<3> walls(unit_settings<3>());
    walls.add_fixed({"cube"}, corners, faces);
    return walls;
}
bool in_cube(const Vec<3>& x) { return (x.array() > 0).all() && (x.array() < 12).all(); }
bool out_of_cube(const Vec<3>& x) { return !in_cube(x); }

TEST(Images3D, FillTheCornerOfThreeWallsExactlyAndHardlyOverlapAroundAConvexOne)
{
    auto inside = cube(true), outside = cube(false);
    for (const Vec<3>& x : {Vec<3>(0.5, 0.5, 0.5), Vec<3>(0.5, 0.5, 1.5), Vec<3>(1, 0.6, 0.4), Vec<3>(0.5, 1.5, 1.7)}) {
        const auto filled = look_around<3>(inside, x, in_cube);
        EXPECT_NEAR(filled.volume, 1, exact);
        EXPECT_LT(filled.gradient.norm(), exact);
        const auto beyond = look_around<3>(outside, Vec<3>(-x), out_of_cube); // measured 0.012 / 0.032
        EXPECT_NEAR(beyond.volume, 1, 0.02);
        EXPECT_LT(beyond.gradient.norm(), 0.04);
    }
}

TEST(Images3D, FlushJointOfDifferentMeshesIsOneSheet)
{
    Walls<3> walls(unit_settings<3>()); // the plane z = 0: one body of two triangles, beside it a fan of small ones
    walls.add_fixed({"plate"}, {-9, -9, 0, 0, -9, 0, 0, 9, 0, -9, 9, 0}, {{0, 1, 2, 3}});
    std::vector<double> x = {4.1, 0.3, 0, 0, -9, 0, 9, -9, 0, 9, 9, 0, 0, 9, 0, 0, 1.7, 0, 0, -2.2, 0};
    walls.add_fixed({"fan"}, x,
                    {{0, 1, 2, -1}, {0, 2, 3, -1}, {0, 3, 4, -1}, {0, 4, 5, -1}, {0, 5, 6, -1}, {0, 6, 1, -1}});
    for (const double place : {-1.0, -0.1, 0.05, 0.7}) {
        const auto seen = look_around<3>(walls, {place, 0.2, 0.6}, [](const Vec<3>& y) { return y.z() > 0; });
        EXPECT_EQ(walls.contacts().planes.size(), 1u);
        EXPECT_NEAR(seen.volume, 1, exact);
        EXPECT_LT(seen.gradient.norm(), exact);
    }
}

TEST(Images3D, FansPast40DegreesAsIn2D)
{
    for (const double turn : {8.0, -8.0, 12.0, -12.0}) { // 60 degrees in all, hollow and bulging
        const double length = 1.5 * std::abs(turn) / 8;
        std::vector<Vec<2>> points{Vec<2>(20, 0), Vec<2>(0, 0)};
        double heading = 180;
        for (double turned = 0; turned < 60; turned += std::abs(turn)) {
            heading -= turn;
            points.push_back(points.back() + polar(length, heading));
        }
        points.back() += polar(20, heading);
        auto walls = extruded({points}, 5);
        const auto is_fluid = [&](const Vec<3>& x) {
            bool all = true, any = false;
            for (std::size_t k = 0; k + 1 < points.size(); ++k) {
                const Vec<2> normal = base::area_vector(base::Simplex<2>{points[k], points[k + 1]});
                const bool front = (Vec<2>(x.x(), x.y()) - points[k]).dot(normal) > 0;
                all = all && front;
                any = any || front;
            }
            return turn > 0 ? all : any;
        };
        for (std::size_t k = 1; k + 2 < points.size(); ++k)
            for (const double height : {0.5, 1.0}) {
                const Vec<2> along = (points[k + 1] - points[k]).normalized();
                const Vec<2> x = points[k] + 0.3 * along + height * Vec<2>(along.y(), -along.x());
                const auto seen = look_around<3>(walls, at_middle(x), is_fluid);
                EXPECT_NEAR(seen.volume, 1, 0.06) << turn << " degrees, facet " << k << ", height " << height;
                EXPECT_LT(seen.gradient.norm(), 0.12) << turn << " degrees, facet " << k << ", height " << height;
            }
    }
}

TEST(Images3D, EndAtTheFreeEdgeOfASheet)
{
    Walls<3> walls(unit_settings<3>()); // z = 0, x < 0, drawn on its upper side alone
    walls.add_fixed({"sheet"}, {0, -20, 0, 0, 20, 0, -20, 20, 0, -20, -20, 0}, {{0, 1, 2, 3}});
    const auto is_fluid = [](const Vec<3>& y) { return y.z() > 0 || y.x() > 0; };
    for (const double x : {-2.0, -1.0, -0.3, 0.3, 1.0, 2.0})
        for (const double z : {0.5, 1.0}) {
            const auto seen = look_around<3>(walls, {x, 0.3, z}, is_fluid);
            EXPECT_NEAR(seen.volume, 1, 0.04) << x << " " << z;
            EXPECT_LT(seen.gradient.norm(), 0.06) << x << " " << z;
        }
    planes_at<3>(walls, {0.3, 0.3, -0.5}); // beyond the edge nobody is inside
    EXPECT_EQ(walls.penetration().count, 0);
}

/// Largest change of the images' volume along a straight way in steps of 1/20 dx.
template<class IsFluid>
double largest_jump_3d(Walls<3>& walls, const IsFluid& is_fluid, const Vec<3>& from, const Vec<3>& to)
{
    const int steps = static_cast<int>(std::ceil((to - from).norm() / 0.05));
    double jump = 0, last = look_around<3>(walls, from, is_fluid, 0.2).volume;
    for (int s = 1; s <= steps; ++s) {
        const double now =
            look_around<3>(walls, Vec<3>(from + (double(s) / steps) * (to - from)), is_fluid, 0.2).volume;
        jump = std::max(jump, std::abs(now - last));
        last = now;
    }
    return jump;
}

TEST(Images3D, VolumeIsContinuousAroundCornersAndEdges)
{
    auto outside = cube(false), inside = cube(true);
    EXPECT_LT(largest_jump_3d(outside, out_of_cube, {-0.5, 2, 2}, {-0.5, -0.6, -0.7}), 0.03);
    EXPECT_LT(largest_jump_3d(outside, out_of_cube, {2, -0.5, 0.4}, {-0.6, -0.5, 0.4}), 0.03);
    EXPECT_LT(largest_jump_3d(inside, in_cube, {3, 0.5, 2.6}, {0.4, 0.5, 0.3}), 0.02);
}

/// Both faces of a plate in the plane x = 0 and `thickness`, in y < 0; its other edges far away.
Walls<3> plate(double thickness)
{
    Walls<3> walls(unit_settings<3>());
    std::vector<double> corners;
    for (int v = 0; v < 8; ++v)
        corners.insert(corners.end(),
                       {(v & 1) != 0 ? thickness : 0.0, (v & 2) != 0 ? 0.0 : -20.0, (v & 4) != 0 ? 20.0 : -20.0});
    std::vector<std::array<int, 4>> faces = {{0, 4, 6, 2}, {1, 3, 7, 5}};
    if (thickness > 0) faces.push_back({2, 6, 7, 3});
    walls.add_fixed({"plate"}, corners, faces);
    return walls;
}

TEST(ThinPlate3D, HasTwoSidesThatDoNotSeeEachOther)
{
    for (const double thickness : {0.0, 1.0}) {
        auto walls = plate(thickness);
        const auto left = planes_at<3>(walls, {-0.5, -3, 0.2}), right = planes_at<3>(walls, {thickness + 0.5, -3, 0.2});
        ASSERT_EQ(left.size(), 1u) << thickness;
        ASSERT_EQ(right.size(), 1u) << thickness;
        EXPECT_NEAR(left[0].normal.x(), -1, 1e-12);
        EXPECT_NEAR(right[0].normal.x(), 1, 1e-12);
        EXPECT_FALSE(walls.may_interact({-0.5, -3, 0}, {thickness + 0.5, -3.1, 0.2}));
        EXPECT_FALSE(walls.may_interact({thickness + 0.5, -3, 0}, {-0.5, -3.1, 0.2}));
        EXPECT_TRUE(walls.may_interact({-0.5, -3, 0}, {-0.4, -4, 0.5}));
        EXPECT_TRUE(walls.may_interact({-0.5, 0.3, 0}, {thickness + 0.5, 0.2, 0.3})); // beyond the edge
    }
}

} // namespace
} // namespace sph

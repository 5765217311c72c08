// SPDX-License-Identifier: MIT
// What is kept of facets that stand still must give the same as looking at all facets anew.
#include "sph_solver/walls/touching.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace sph {
namespace {

constexpr double tolerance = 0.01;

/// A square of 2 n^2 triangles with side 1 at height z.
std::pair<std::vector<Vec<3>>, std::vector<WallFacet<3>>> sheet(int n, double x, double z)
{
    std::vector<Vec<3>> vertices;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) vertices.emplace_back(x + i / double(n), j / double(n), z);
    std::vector<WallFacet<3>> facets;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int v = i + (n + 1) * j;
            for (const auto& corners : {std::array{v, v + 1, v + n + 2}, std::array{v, v + n + 2, v + n + 1}})
                facets.push_back({.vertex = corners, .corner = {0, 1, 2}});
        }
    return {vertices, facets};
}

void set_plate(WallFacets<3>& facets, double x)
{
    const auto [vertices, plate] = sheet(3, x, 0.0);
    VertexMotion<3> motion{vertices, std::vector<Vec<3>>(vertices.size(), Vec<3>::Zero()), {}};
    motion.acceleration = motion.velocity;
    facets.set_moving({"plate"}, motion, plate);
    facets.move(0);
}

void expect_as_by_brute_force(const Touching<3>& touching, const WallFacets<3>& facets)
{
    for (int f = 0; f < facets.size(); ++f) {
        std::vector<int> wanted;
        for (int g = 0; g < facets.size(); ++g)
            if (g != f && base::simplex_distance<3>(facets.corners(f), facets.corners(g)) <= tolerance)
                wanted.push_back(g);
        const auto found = touching.of(f);
        EXPECT_TRUE(std::ranges::equal(wanted, found)) << f;
        for (int s = 0; s < 3; ++s) {
            const auto& x = facets.corners(f);
            const Vec<3> middle =
                0.5 * (x[static_cast<std::size_t>((s + 1) % 3)] + x[static_cast<std::size_t>((s + 2) % 3)]);
            const bool met = std::ranges::any_of(wanted, [&](int g) {
                return base::closest_point(facets.corners(g), middle).squared_distance <= tolerance * tolerance;
            });
            EXPECT_EQ(touching.is_free_side(f, s), !met) << f << ' ' << s;
        }
    }
}

TEST(Touching, IsThatOfAllFacetsWhereverTheMovingOnesAre)
{
    WallFacets<3> facets;
    const auto [vertices, floor] = sheet(5, 0.0, 0.0);
    facets.add_fixed({"floor"}, vertices, floor);
    Touching<3> touching;
    touching.find(facets, tolerance);
    expect_as_by_brute_force(touching, facets);
    for (const double x : {2.0, 1.0, 1.2, -1.0}) { // away, joined to the floor, away, joined on the other side
        set_plate(facets, x);
        touching.find(facets, tolerance);
        expect_as_by_brute_force(touching, facets);
    }
}

} // namespace
} // namespace sph

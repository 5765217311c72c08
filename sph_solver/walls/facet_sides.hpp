// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/geometry.hpp"
#include "sph_solver/numerics/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

/// \file
/// Sides and angles of a facet. Side s lies opposite to corner s: the other end of a segment, an edge of a triangle.
namespace sph {

/// Unit vector in the facet, across the side opposite to corner `side` and out of the facet.
inline Vec<2> away_from_side(const base::Simplex<2>& corners, int side)
{
    const auto s = static_cast<std::size_t>(side);
    return (corners[1 - s] - corners[s]).normalized();
}
inline Vec<3> away_from_side(const base::Simplex<3>& corners, int side)
{
    const auto s = static_cast<std::size_t>(side);
    const Vec<3>& from = corners[(s + 1) % 3];
    const Vec<3> edge = (corners[(s + 2) % 3] - from).normalized(), across = from - corners[s];
    return (across - across.dot(edge) * edge).normalized();
}

inline Vec<2> middle_of_side(const base::Simplex<2>& corners, int side)
{
    return corners[static_cast<std::size_t>(1 - side)];
}
inline Vec<3> middle_of_side(const base::Simplex<3>& corners, int side)
{
    const auto s = static_cast<std::size_t>(side);
    return 0.5 * (corners[(s + 1) % 3] + corners[(s + 2) % 3]);
}

/// Normal of the plane through x and a side, away from the facet; its length is that of the view across the side.
inline Vec<2> past_side(const Vec<2>& x, const base::Simplex<2>& corners, int side)
{
    const Vec<2> ray = middle_of_side(corners, side) - x, normal(ray.y(), -ray.x());
    return normal.dot(away_from_side(corners, side)) < 0 ? Vec<2>(-normal) : normal;
}
inline Vec<3> past_side(const Vec<3>& x, const base::Simplex<3>& corners, int side)
{
    const auto s = static_cast<std::size_t>(side);
    const Vec<3> ray = middle_of_side(corners, side) - x, edge = corners[(s + 2) % 3] - corners[(s + 1) % 3];
    const Vec<3> normal(ray.y() * edge.z() - ray.z() * edge.y(), ray.z() * edge.x() - ray.x() * edge.z(),
                        ray.x() * edge.y() - ray.y() * edge.x());
    return normal.dot(away_from_side(corners, side)) < 0 ? Vec<3>(-normal) : normal;
}

/// The angle that a facet takes up around one of its own points, in half turns; all ends of segments count alike.
inline double angle_at(const base::Simplex<2>&, const std::array<double, 2>&) { return 1.0; }
inline double angle_at(const base::Simplex<3>& corners, const std::array<double, 3>& weight)
{
    for (std::size_t c = 0; c < 3; ++c) {
        if (weight[c] < 1) continue;
        const Vec<3> a = corners[(c + 1) % 3] - corners[c], b = corners[(c + 2) % 3] - corners[c];
        return std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0)) / std::numbers::pi;
    }
    return 1.0;
}

} // namespace sph

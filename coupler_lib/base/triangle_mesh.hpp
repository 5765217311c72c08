// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/geometry.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace base {

/// A surface of triangles in space that share their corners; a triangle's corners run counterclockwise seen from the
/// side that its normal points to.
struct TriangleMesh {
    std::vector<Point<3>> corners; ///< [m]
    std::vector<std::array<int, 3>> triangles;

    [[nodiscard]] Simplex<3> triangle(std::size_t k) const
    {
        const auto at = [&](std::size_t c) { return corners[static_cast<std::size_t>(triangles[k][c])]; };
        return {at(0), at(1), at(2)};
    }
};

/// Joins loose triangles at equal corners (equal to the last bit); leaves out those that have two corners in one place.
TriangleMesh join(const std::vector<Simplex<3>>& triangles);

/// Throws Error(bad_input) unless every edge belongs to two triangles that run through it in opposite directions: no
/// holes, no triangle turned over. `what` begins the message.
void require_closed(const TriangleMesh& mesh, const std::string& what);

/// Volume inside a closed mesh, sum of a . (b x c) / 6 [m^3]; negative when the normals point inwards.
double enclosed_volume(const TriangleMesh& mesh);

/// Where an upward line passes through a triangle.
struct Crossing {
    double z = 0;    ///< [m]
    int winding = 0; ///< +1 where it goes in (the normal points down), -1 where it comes out
};

/// The crossing of the line through (x, y), along z; none when it misses. A line through an edge or a corner counts for
/// just one of the triangles around, as if it were moved by (e, e^2) with an e too small to matter, so that the windings
/// along a line add up to 0 for every closed mesh.
std::optional<Crossing> crossing_of_vertical(const Simplex<3>& triangle, double x, double y);

} // namespace base

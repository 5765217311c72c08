// SPDX-License-Identifier: MIT
#include "coupler_lib/base/triangle_mesh.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <map>

namespace base {
namespace {

/// Twice the area of the projected triangle a, b, (x, y); exactly opposite when a and b change places.
double side_of(const Point<3>& a, const Point<3>& b, double x, double y)
{
    const bool swapped = b.x() < a.x() || (b.x() == a.x() && b.y() < a.y());
    const Point<3>&p = swapped ? b : a, &q = swapped ? a : b;
    const double area = (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
    return swapped ? -area : area;
}

int sign(double value) { return (value > 0) - (value < 0); }

/// Side of the line a, b that (x + e, y + e^2) lies on: 1 left, -1 right, 0 when a and b coincide in the projection.
int side_sign(const Point<3>& a, const Point<3>& b, double x, double y)
{
    const int side = sign(side_of(a, b, x, y));
    if (side != 0) return side;
    return a.y() != b.y() ? sign(a.y() - b.y()) : sign(b.x() - a.x());
}

} // namespace

TriangleMesh join(const std::vector<Simplex<3>>& triangles)
{
    TriangleMesh mesh;
    std::map<std::array<double, 3>, int> numbers;
    for (const auto& triangle : triangles) {
        std::array<int, 3> corners{};
        for (std::size_t c = 0; c < 3; ++c) {
            const Point<3> x = triangle[c] + Point<3>::Zero(); // -0 becomes 0
            const auto [found, is_new] =
                numbers.try_emplace({x.x(), x.y(), x.z()}, static_cast<int>(mesh.corners.size()));
            if (is_new) mesh.corners.push_back(x);
            corners[c] = found->second;
        }
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            mesh.triangles.push_back(corners);
    }
    return mesh;
}

void require_closed(const TriangleMesh& mesh, const std::string& what)
{
    std::map<std::pair<int, int>, int> uses; // of each edge in each direction
    for (const auto& corners : mesh.triangles)
        for (std::size_t c = 0; c < 3; ++c) ++uses[{corners[c], corners[(c + 1) % 3]}];
    std::size_t bad = 0;
    Point<3> where = Point<3>::Zero();
    for (const auto& [edge, count] : uses) {
        const auto back = uses.find({edge.second, edge.first});
        if (count == 1 && back != uses.end() && back->second == 1) continue;
        if (bad++ == 0)
            where = 0.5 * (mesh.corners[static_cast<std::size_t>(edge.first)] +
                           mesh.corners[static_cast<std::size_t>(edge.second)]);
    }
    require_input(bad == 0, what, ": the surface is not closed: ", bad,
                  " edges without a neighbour that runs the other way", ", the first at (", where.x(), ", ", where.y(),
                  ", ", where.z(), ") m; close the holes and turn all normals outwards");
    require_input(!mesh.triangles.empty(), what, ": the surface has no triangles");
}

double enclosed_volume(const TriangleMesh& mesh)
{
    double volume = 0.0;
    const Point<3> origin = mesh.corners.empty() ? Point<3>(Point<3>::Zero()) : mesh.corners.front();
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const auto triangle = mesh.triangle(k);
        volume += (triangle[0] - origin).dot(area_vector(triangle)) / 3.0;
    }
    return volume;
}

std::optional<Crossing> crossing_of_vertical(const Simplex<3>& triangle, double x, double y)
{
    std::array<double, 3> share{}; // twice the projected area opposite to each corner
    int side = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto &a = triangle[(c + 1) % 3], &b = triangle[(c + 2) % 3];
        const int turned = side_sign(a, b, x, y);
        if (turned == 0 || (side != 0 && turned != side)) return std::nullopt;
        side = turned;
        share[c] = side_of(a, b, x, y);
    }
    const double whole = share[0] + share[1] + share[2];
    if (whole == 0.0) return std::nullopt;
    const double z = (share[0] * triangle[0].z() + share[1] * triangle[1].z() + share[2] * triangle[2].z()) / whole;
    return Crossing{z, -side};
}

} // namespace base

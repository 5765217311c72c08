// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/facet_geometry.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>

namespace coupler {
namespace {

const double* corner(const std::array<int, 4>& nodes, int k, const std::vector<double>& points, int dimension)
{
    return points.data() + static_cast<std::ptrdiff_t>(nodes[static_cast<std::size_t>(k)]) * dimension;
}

} // namespace

int corner_count(const std::array<int, 4>& nodes)
{
    int count = 0;
    while (count < 4 && nodes[static_cast<std::size_t>(count)] >= 0) ++count;
    return count;
}

double facet_measure(const std::array<int, 4>& nodes, const std::vector<double>& points, int dimension)
{
    const double* a = corner(nodes, 0, points, dimension);
    const double* b = corner(nodes, 1, points, dimension);
    if (dimension == 2) return std::sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]));
    const double* c = corner(nodes, 2, points, dimension);
    const double* d = corner_count(nodes) == 4 ? corner(nodes, 3, points, dimension) : a;
    const double p[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]}; // diagonals of a b c d; for a triangle d = a
    const double q[3] = {d[0] - b[0], d[1] - b[1], d[2] - b[2]};
    const double n[3] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    return 0.5 * std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

std::array<double, 3> facet_centre(const std::array<int, 4>& nodes, const std::vector<double>& points, int dimension)
{
    const int corners = corner_count(nodes);
    std::array<double, 3> centre{};
    for (int k = 0; k < corners; ++k)
        for (int d = 0; d < dimension; ++d)
            centre[static_cast<std::size_t>(d)] += corner(nodes, k, points, dimension)[d] / corners;
    return centre;
}

bool touches(const std::array<int, 4>& nodes, const std::vector<double>& points, int dimension, const RegionBox& region)
{
    for (int d = 0; d < dimension; ++d) {
        const double first = corner(nodes, 0, points, dimension)[d];
        double low = first;
        double high = first;
        for (int k = 1; k < 4 && nodes[static_cast<std::size_t>(k)] >= 0; ++k) {
            low = std::min(low, corner(nodes, k, points, dimension)[d]);
            high = std::max(high, corner(nodes, k, points, dimension)[d]);
        }
        const auto axis = static_cast<std::size_t>(d);
        if (!(region.low[axis] <= region.high[axis] && low <= region.high[axis] && high >= region.low[axis]))
            return false;
    }
    return true;
}

std::string point_text(const double* point, int dimension)
{
    std::string text = base::text("(", point[0]);
    for (int d = 1; d < dimension; ++d) text += base::text(", ", point[d]);
    return text + ")";
}

} // namespace coupler

// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/surface.hpp"

#include <array>
#include <string>
#include <vector>

namespace coupler {

/// Number of corners in use: the leading entries that are not -1.
int corner_count(const std::array<int, 4>& nodes);

/// Length of a segment [m] or area of a triangle or quadrilateral [m^2] (half the cross product of the diagonals).
/// \param points  nodes * dimension
double facet_measure(const std::array<int, 4>& nodes, const std::vector<double>& points, int dimension);

/// Mean of the corners.
std::array<double, 3> facet_centre(const std::array<int, 4>& nodes, const std::vector<double>& points, int dimension);

/// Whether the box around the facet's corners touches the region; false for an empty region or points that are not
/// numbers.
bool touches(const std::array<int, 4>& nodes, const std::vector<double>& points, int dimension,
             const RegionBox& region);

/// "(0.1, 0.02)" or "(0.1, 0.02, 0)"
std::string point_text(const double* point, int dimension);

} // namespace coupler

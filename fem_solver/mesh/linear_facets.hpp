// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/mesh/mesh.hpp"

#include <array>

namespace fem {

/// Faces cut into linear facets on the elements' own nodes, as the fluid sees them: a quadratic edge gives two
/// segments, a face of Hexa20 six triangles, of Hexa27 four quadrilaterals, of Tet10 four triangles.
///
/// \return node ids per facet, unused entries -1; 2D: (a, b) with the body on the left, outward normal (t_y, -t_x);
///         3D: counterclockwise seen from outside.
std::vector<std::array<int, 4>> linear_facets(const Mesh& mesh, const std::vector<MeshFace>& faces);

} // namespace fem

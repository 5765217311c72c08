// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/lines.hpp"
#include "fem_solver/element/simplex_shapes.hpp"

#include <array>

namespace fem {

/// Three-node triangle with constant strain. Corners (0,0), (1,0), (0,1) of the reference triangle.
/// It locks in bending and near incompressibility; for meshing around corners, not for accuracy.
struct Tri3 : LinearSimplex<2> {
    using Face = Line2;
    static constexpr std::array<std::array<double, 2>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
    static constexpr std::array<std::array<int, 2>, 3> faces{{{0, 1}, {1, 2}, {2, 0}}};
    static constexpr std::array<std::array<int, 3>, 1> linear_parts{{{0, 1, 2}}};
};

/// Six-node triangle: corners as Tri3, then the middles of the edges 0-1, 1-2, 2-0.
struct Tri6 : QuadraticSimplex<Tri6, Tri3> {
    using Face = Line3;
    static constexpr std::array<std::array<double, 2>, 6> corners{
        {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
    static constexpr std::array<std::array<int, 2>, 3> edges{{{0, 1}, {1, 2}, {2, 0}}}; ///< ends of nodes 3, 4, 5
    static constexpr std::array<std::array<int, 3>, 3> faces{{{0, 1, 3}, {1, 2, 4}, {2, 0, 5}}};
    /// As the face of a Tet10: four linear triangles on the element's own nodes.
    static constexpr std::array<std::array<int, 3>, 4> linear_parts{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
};

} // namespace fem

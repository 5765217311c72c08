// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/triangles.hpp"

namespace fem {

/// Four-node tetrahedron with constant strain. Corners: the origin and the unit points of the three axes.
struct Tet4 : LinearSimplex<3> {
    using Face = Tri3;
    static constexpr std::array<std::array<double, 3>, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    /// Counterclockwise seen from outside.
    static constexpr std::array<std::array<int, 3>, 4> faces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
};

/// Ten-node tetrahedron: corners as Tet4, then the middles of the edges 0-1, 1-2, 2-0, 0-3, 1-3, 2-3.
struct Tet10 : QuadraticSimplex<Tet10, Tet4> {
    using Face = Tri6;
    static constexpr std::array<std::array<double, 3>, 10> corners{{{0, 0, 0},
                                                                    {1, 0, 0},
                                                                    {0, 1, 0},
                                                                    {0, 0, 1},
                                                                    {0.5, 0, 0},
                                                                    {0.5, 0.5, 0},
                                                                    {0, 0.5, 0},
                                                                    {0, 0, 0.5},
                                                                    {0.5, 0, 0.5},
                                                                    {0, 0.5, 0.5}}};
    static constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
    static constexpr std::array<std::array<int, 6>, 4> faces{
        {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}}};
};

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/element_type.hpp"

#include <algorithm>
#include <vector>

namespace fem {

using LatticePoint = std::array<int, 3>;

/// Nodes of a simplex on the lattice: its corners, then for quadratic shapes the middles of its edges.
template<class Shape> std::vector<LatticePoint> simplex_nodes(std::vector<LatticePoint> points)
{
    if constexpr (!Shape::linear)
        for (const auto& [a, b] : Shape::edges) {
            LatticePoint middle;
            for (int k = 0; k < 3; ++k) middle[k] = (points[a][k] + points[b][k]) / 2;
            points.push_back(middle);
        }
    return points;
}

/// Two triangles or six tetrahedra of a cell, one for each order of the axes on the way from its lowest to its highest
/// corner (Kuhn's division): all share that diagonal, and neighbouring cells fit.
template<class Shape> std::vector<std::vector<LatticePoint>> simplices_of_cell(int step)
{
    constexpr int D = Shape::dimension;
    std::vector<std::vector<LatticePoint>> elements;
    std::array<int, D> axes;
    for (int k = 0; k < D; ++k) axes[k] = k;
    do {
        std::vector<LatticePoint> corners{{0, 0, 0}};
        for (const int axis : axes) {
            corners.push_back(corners.back());
            corners.back()[axis] = step;
        }
        int swaps = 0; // an odd order of the axes turns the element inside out
        for (int a = 0; a < D; ++a)
            for (int b = a + 1; b < D; ++b) swaps += axes[a] > axes[b];
        if (swaps % 2) std::swap(corners[1], corners[2]);
        elements.push_back(simplex_nodes<Shape>(corners));
    } while (std::next_permutation(axes.begin(), axes.end()));
    return elements;
}

/// The elements of one cell of a block, each as the lattice points of its nodes: one quadrilateral or hexahedron, or
/// simplices_of_cell. \param step lattice points per cell and direction, 1 for linear and 2 for quadratic shapes.
template<class Shape> std::vector<std::vector<LatticePoint>> elements_of_cell(int step)
{
    if constexpr (is_simplex<Shape>) {
        return simplices_of_cell<Shape>(step);
    } else {
        std::vector<LatticePoint> points;
        for (const auto& corner : Shape::corners) {
            LatticePoint p{};
            for (int k = 0; k < Shape::dimension; ++k) p[k] = step * (corner[k] + 1) / 2;
            points.push_back(p);
        }
        return {points};
    }
}

} // namespace fem

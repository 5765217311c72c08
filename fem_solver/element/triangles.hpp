// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/lines.hpp"

#include <Eigen/Core>

#include <array>

namespace fem {

/// Three-node triangle with constant strain. Corners (0,0), (1,0), (0,1) of the reference triangle.
///
///     N = (1 - xi - eta, xi, eta)
///
/// It locks in bending and near incompressibility; for meshing around corners, not for accuracy.
struct Tri3 {
    using Face = Line2;
    static constexpr bool simplex = true;
    static constexpr int dimension = 2;
    static constexpr int nodes = 3;
    static constexpr int gauss = 1; ///< degree that the default rule integrates exactly
    static constexpr int full_gauss = 1;
    static constexpr int mass_gauss = 2;
    static constexpr bool linear = true;
    static constexpr int pressure_modes = 0;
    static constexpr std::array<std::array<double, 2>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
    static constexpr std::array<std::array<int, 2>, 3> faces{{{0, 1}, {1, 2}, {2, 0}}};
    static constexpr std::array<std::array<int, 3>, 1> linear_parts{{{0, 1, 2}}};

    static Eigen::Matrix<double, 1, 3> values(const Eigen::Vector2d& xi) { return {1 - xi[0] - xi[1], xi[0], xi[1]}; }
    static Eigen::Matrix<double, 2, 3> gradients(const Eigen::Vector2d&)
    {
        Eigen::Matrix<double, 2, 3> g;
        g << -1, 1, 0, -1, 0, 1;
        return g;
    }
};

/// Six-node triangle: corners as Tri3, then the middles of the edges 0-1, 1-2, 2-0. With L = values of Tri3:
///
///     corner  N_a = L_a (2 L_a - 1),      middle  N_ab = 4 L_a L_b
struct Tri6 {
    using Face = Line3;
    static constexpr bool simplex = true;
    static constexpr int dimension = 2;
    static constexpr int nodes = 6;
    static constexpr int gauss = 2;
    static constexpr int full_gauss = 2;
    static constexpr int mass_gauss = 4;
    static constexpr bool linear = false;
    static constexpr int pressure_modes = 1;
    static constexpr std::array<std::array<double, 2>, 6> corners{
        {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
    static constexpr std::array<std::array<int, 2>, 3> edges{{{0, 1}, {1, 2}, {2, 0}}}; ///< ends of nodes 3, 4, 5
    static constexpr std::array<std::array<int, 3>, 3> faces{{{0, 1, 3}, {1, 2, 4}, {2, 0, 5}}};
    /// As the face of a Tet10: four linear triangles on the element's own nodes.
    static constexpr std::array<std::array<int, 3>, 4> linear_parts{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};

    static Eigen::Matrix<double, 1, 6> values(const Eigen::Vector2d& xi)
    {
        const auto l = Tri3::values(xi);
        Eigen::Matrix<double, 1, 6> n;
        for (int a = 0; a < 3; ++a) n[a] = l[a] * (2 * l[a] - 1);
        for (int m = 0; m < 3; ++m) n[3 + m] = 4 * l[edges[m][0]] * l[edges[m][1]];
        return n;
    }
    static Eigen::Matrix<double, 2, 6> gradients(const Eigen::Vector2d& xi)
    {
        const auto l = Tri3::values(xi);
        const auto d = Tri3::gradients(xi);
        Eigen::Matrix<double, 2, 6> g;
        for (int a = 0; a < 3; ++a) g.col(a) = (4 * l[a] - 1) * d.col(a);
        for (int m = 0; m < 3; ++m) {
            const auto [a, b] = edges[m];
            g.col(3 + m) = 4 * (l[a] * d.col(b) + l[b] * d.col(a));
        }
        return g;
    }
};

} // namespace fem

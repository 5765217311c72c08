// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/triangles.hpp"

#include <Eigen/Core>

#include <array>

namespace fem {

/// Four-node tetrahedron with constant strain. Corners: the origin and the unit points of the three axes.
///
///     N = (1 - xi - eta - zeta, xi, eta, zeta)
struct Tet4 {
    using Face = Tri3;
    static constexpr bool simplex = true;
    static constexpr int dimension = 3;
    static constexpr int nodes = 4;
    static constexpr int gauss = 1;
    static constexpr int full_gauss = 1;
    static constexpr int mass_gauss = 2;
    static constexpr bool linear = true;
    static constexpr int pressure_modes = 0;
    static constexpr std::array<std::array<double, 3>, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    /// Counterclockwise seen from outside.
    static constexpr std::array<std::array<int, 3>, 4> faces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

    static Eigen::Matrix<double, 1, 4> values(const Eigen::Vector3d& xi)
    {
        return {1 - xi[0] - xi[1] - xi[2], xi[0], xi[1], xi[2]};
    }
    static Eigen::Matrix<double, 3, 4> gradients(const Eigen::Vector3d&)
    {
        Eigen::Matrix<double, 3, 4> g;
        g << -1, 1, 0, 0, -1, 0, 1, 0, -1, 0, 0, 1;
        return g;
    }
};

/// Ten-node tetrahedron: corners as Tet4, then the middles of the edges 0-1, 1-2, 2-0, 0-3, 1-3, 2-3.
///
///     corner  N_a = L_a (2 L_a - 1),      middle  N_ab = 4 L_a L_b,      L = values of Tet4
struct Tet10 {
    using Face = Tri6;
    static constexpr bool simplex = true;
    static constexpr int dimension = 3;
    static constexpr int nodes = 10;
    static constexpr int gauss = 2;
    static constexpr int full_gauss = 2;
    static constexpr int mass_gauss = 4;
    static constexpr bool linear = false;
    static constexpr int pressure_modes = 1;
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

    static Eigen::Matrix<double, 1, 10> values(const Eigen::Vector3d& xi)
    {
        const auto l = Tet4::values(xi);
        Eigen::Matrix<double, 1, 10> n;
        for (int a = 0; a < 4; ++a) n[a] = l[a] * (2 * l[a] - 1);
        for (int m = 0; m < 6; ++m) n[4 + m] = 4 * l[edges[m][0]] * l[edges[m][1]];
        return n;
    }
    static Eigen::Matrix<double, 3, 10> gradients(const Eigen::Vector3d& xi)
    {
        const auto l = Tet4::values(xi);
        const auto d = Tet4::gradients(xi);
        Eigen::Matrix<double, 3, 10> g;
        for (int a = 0; a < 4; ++a) g.col(a) = (4 * l[a] - 1) * d.col(a);
        for (int m = 0; m < 6; ++m) {
            const auto [a, b] = edges[m];
            g.col(4 + m) = 4 * (l[a] * d.col(b) + l[b] * d.col(a));
        }
        return g;
    }
};

} // namespace fem

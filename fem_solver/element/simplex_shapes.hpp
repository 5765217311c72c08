// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace fem {

/// What the linear triangle (D = 2) and tetrahedron (D = 3) share: the barycentric coordinates as shape functions.
///
///     N = (1 - xi_1 - .. - xi_D, xi_1, .., xi_D)
template<int D> struct LinearSimplex {
    static constexpr bool simplex = true;
    static constexpr int dimension = D;
    static constexpr int nodes = D + 1;
    static constexpr int gauss = 1; ///< degree that the default rule integrates exactly
    static constexpr int full_gauss = 1;
    static constexpr int mass_gauss = 2;
    static constexpr bool linear = true;
    static constexpr int pressure_modes = 0;

    using Point = Eigen::Matrix<double, D, 1>;
    using Gradients = Eigen::Matrix<double, D, D + 1>;

    static Eigen::Matrix<double, 1, D + 1> values(const Point& xi)
    {
        Eigen::Matrix<double, 1, D + 1> n;
        n[0] = 1;
        for (int k = 0; k < D; ++k) {
            n[0] -= xi[k];
            n[k + 1] = xi[k];
        }
        return n;
    }
    static Gradients gradients(const Point&)
    {
        Gradients g = Gradients::Zero();
        g.col(0).setConstant(-1);
        g.template rightCols<D>().setIdentity();
        return g;
    }
};

/// What the quadratic ones share; `Shape` names the ends of its edges, `Corners` is the linear shape. With L = values of it:
///
///     corner  N_a = L_a (2 L_a - 1),      middle  N_ab = 4 L_a L_b
template<class Shape, class Corners> struct QuadraticSimplex {
    static constexpr bool simplex = true;
    static constexpr int dimension = Corners::dimension;
    static constexpr int corner_nodes = Corners::nodes;
    static constexpr int nodes = corner_nodes + dimension * (dimension + 1) / 2; ///< corners, then a node on each edge
    static constexpr int gauss = 2;
    static constexpr int full_gauss = 2;
    static constexpr int mass_gauss = 4;
    static constexpr bool linear = false;
    static constexpr int pressure_modes = 1;

    using Point = Eigen::Matrix<double, dimension, 1>;

    static Eigen::Matrix<double, 1, nodes> values(const Point& xi)
    {
        const auto l = Corners::values(xi);
        Eigen::Matrix<double, 1, nodes> n;
        for (int a = 0; a < corner_nodes; ++a) n[a] = l[a] * (2 * l[a] - 1);
        for (int m = corner_nodes; m < nodes; ++m) {
            const auto [a, b] = Shape::edges[m - corner_nodes];
            n[m] = 4 * l[a] * l[b];
        }
        return n;
    }
    static Eigen::Matrix<double, dimension, nodes> gradients(const Point& xi)
    {
        const auto l = Corners::values(xi);
        const auto d = Corners::gradients(xi);
        Eigen::Matrix<double, dimension, nodes> g;
        for (int a = 0; a < corner_nodes; ++a) g.col(a) = (4 * l[a] - 1) * d.col(a);
        for (int m = corner_nodes; m < nodes; ++m) {
            const auto [a, b] = Shape::edges[m - corner_nodes];
            g.col(m) = 4 * (l[a] * d.col(b) + l[b] * d.col(a));
        }
        return g;
    }
};

} // namespace fem

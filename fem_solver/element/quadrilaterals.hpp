// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/lines.hpp"

#include <Eigen/Core>

#include <array>

namespace fem {

/// Four-node quadrilateral. Corners counterclockwise from (-1, -1).
///
///     N_a = (1 + xi_a xi)(1 + eta_a eta) / 4
///
/// Alone it locks in bending (shear) and near incompressibility (volume); see EnhancedModes for the cure.
struct Quad4 {
    using Face = Line2;
    static constexpr int dimension = 2;
    static constexpr int nodes = 4;
    static constexpr int gauss = 2;      ///< points per direction used by default
    static constexpr int full_gauss = 2; ///< points per direction of full integration
    static constexpr int mass_gauss = 2; ///< exact for the mass of a parallelogram
    static constexpr bool linear = true;
    static constexpr int pressure_modes = 1; ///< of the mixed formulation: 1 constant, 1 + dimension linear, 0: none
    static constexpr std::array<std::array<int, 2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    /// Edges with the body on the left, so that (t_y, -t_x) points outward.
    static constexpr std::array<std::array<int, 2>, 4> faces{{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
    /// As the face of a Hexa8: one linear quadrilateral.
    static constexpr std::array<std::array<int, 4>, 1> linear_parts{{{0, 1, 2, 3}}};

    static Eigen::Matrix<double, 1, 4> values(const Eigen::Vector2d& xi)
    {
        Eigen::Matrix<double, 1, 4> n;
        for (int a = 0; a < nodes; ++a) n[a] = 0.25 * (1 + corners[a][0] * xi[0]) * (1 + corners[a][1] * xi[1]);
        return n;
    }
    static Eigen::Matrix<double, 2, 4> gradients(const Eigen::Vector2d& xi)
    {
        Eigen::Matrix<double, 2, 4> g;
        for (int a = 0; a < nodes; ++a) {
            const auto [x, y] = corners[a];
            g.col(a) = Eigen::Vector2d(0.25 * x * (1 + y * xi[1]), 0.25 * y * (1 + x * xi[0]));
        }
        return g;
    }
};

/// Eight-node serendipity quadrilateral. Corners as Quad4, then the middles of the edges 0-1, 1-2, 2-3, 3-0.
///
///     corner  N_a = (1 + xi_a xi)(1 + eta_a eta)(xi_a xi + eta_a eta - 1) / 4
///     middle  N_a = (1 - xi^2)(1 + eta_a eta) / 2   or   (1 + xi_a xi)(1 - eta^2) / 2
///
/// Reduced 2 x 2 integration is the default: it neither locks in bending nor, on the whole, in volume.
struct Quad8 {
    using Face = Line3;
    static constexpr int dimension = 2;
    static constexpr int nodes = 8;
    static constexpr int gauss = 2;
    static constexpr int full_gauss = 3;
    static constexpr int mass_gauss = 3;
    static constexpr bool linear = false;
    static constexpr int pressure_modes = 0;
    static constexpr std::array<std::array<int, 2>, 8> corners{
        {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    static constexpr std::array<std::array<int, 3>, 4> faces{{{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}}};
    /// As the face of a Hexa20: six linear triangles on the element's own nodes.
    static constexpr std::array<std::array<int, 3>, 6> linear_parts{
        {{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {6, 3, 7}, {4, 5, 7}, {5, 6, 7}}};

    static Eigen::Matrix<double, 1, 8> values(const Eigen::Vector2d& xi)
    {
        Eigen::Matrix<double, 1, 8> n;
        for (int a = 0; a < nodes; ++a) {
            const double sx = corners[a][0] * xi[0], sy = corners[a][1] * xi[1];
            if (corners[a][0] == 0)
                n[a] = 0.5 * (1 - xi[0] * xi[0]) * (1 + sy);
            else if (corners[a][1] == 0)
                n[a] = 0.5 * (1 + sx) * (1 - xi[1] * xi[1]);
            else
                n[a] = 0.25 * (1 + sx) * (1 + sy) * (sx + sy - 1);
        }
        return n;
    }
    static Eigen::Matrix<double, 2, 8> gradients(const Eigen::Vector2d& xi)
    {
        Eigen::Matrix<double, 2, 8> g;
        for (int a = 0; a < nodes; ++a) {
            const auto [x, y] = corners[a];
            const double sx = x * xi[0], sy = y * xi[1];
            if (x == 0)
                g.col(a) = Eigen::Vector2d(-xi[0] * (1 + sy), 0.5 * y * (1 - xi[0] * xi[0]));
            else if (y == 0)
                g.col(a) = Eigen::Vector2d(0.5 * x * (1 - xi[1] * xi[1]), -xi[1] * (1 + sx));
            else
                g.col(a) = Eigen::Vector2d(0.25 * x * (1 + sy) * (2 * sx + sy), 0.25 * y * (1 + sx) * (sx + 2 * sy));
        }
        return g;
    }
};

} // namespace fem

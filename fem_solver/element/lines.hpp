// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>

namespace fem {

/// Two-node line, the face of a Quad4. Reference interval xi in [-1, 1], nodes at -1 and 1.
///
///     N_a = (1 + xi_a xi) / 2
struct Line2 {
    static constexpr int dimension = 1;
    static constexpr int nodes = 2;
    static constexpr int gauss = 2; ///< Gauss points per direction that integrate a face load exactly
    static constexpr std::array<std::array<int, 1>, 2> corners{{{-1}, {1}}};
    static constexpr std::array<std::array<int, 2>, 1> linear_parts{{{0, 1}}};

    static Eigen::Matrix<double, 1, 2> values(const Eigen::Matrix<double, 1, 1>& xi)
    {
        return {0.5 * (1 - xi[0]), 0.5 * (1 + xi[0])};
    }
    static Eigen::Matrix<double, 1, 2> gradients(const Eigen::Matrix<double, 1, 1>&) { return {-0.5, 0.5}; }
};

/// Three-node line, the face of a Quad8. Nodes at -1, 1 and, third, the middle 0.
///
///     N_1,2 = xi (xi -+ 1) / 2,   N_3 = 1 - xi^2
struct Line3 {
    static constexpr int dimension = 1;
    static constexpr int nodes = 3;
    static constexpr int gauss = 3;
    static constexpr std::array<std::array<int, 1>, 3> corners{{{-1}, {1}, {0}}};
    /// Linear pieces on the line's own nodes, in the direction of the line: how the edge travels to the fluid.
    static constexpr std::array<std::array<int, 2>, 2> linear_parts{{{0, 2}, {2, 1}}};

    static Eigen::Matrix<double, 1, 3> values(const Eigen::Matrix<double, 1, 1>& xi)
    {
        return {0.5 * xi[0] * (xi[0] - 1), 0.5 * xi[0] * (xi[0] + 1), 1 - xi[0] * xi[0]};
    }
    static Eigen::Matrix<double, 1, 3> gradients(const Eigen::Matrix<double, 1, 1>& xi)
    {
        return {xi[0] - 0.5, xi[0] + 0.5, -2 * xi[0]};
    }
};

} // namespace fem

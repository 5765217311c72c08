// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/quadrilaterals.hpp"

#include <Eigen/Core>

#include <array>

namespace fem {

/// Eight-node hexahedron. Corners 0-3 counterclockwise at zeta = -1, 4-7 above them.
///
///     N_a = (1 + xi_a xi)(1 + eta_a eta)(1 + zeta_a zeta) / 8
struct Hexa8 {
    using Face = Quad4;
    static constexpr int dimension = 3;
    static constexpr int nodes = 8;
    static constexpr int gauss = 2;
    static constexpr int full_gauss = 2;
    static constexpr int mass_gauss = 2;
    static constexpr bool linear = true;
    static constexpr int pressure_modes = 1;
    static constexpr std::array<std::array<int, 3>, 8> corners{
        {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    /// Counterclockwise seen from outside.
    static constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

    static Eigen::Matrix<double, 1, 8> values(const Eigen::Vector3d& xi)
    {
        Eigen::Matrix<double, 1, 8> n;
        for (int a = 0; a < nodes; ++a) {
            const auto [x, y, z] = corners[a];
            n[a] = 0.125 * (1 + x * xi[0]) * (1 + y * xi[1]) * (1 + z * xi[2]);
        }
        return n;
    }
    static Eigen::Matrix<double, 3, 8> gradients(const Eigen::Vector3d& xi)
    {
        Eigen::Matrix<double, 3, 8> g;
        for (int a = 0; a < nodes; ++a) {
            const auto [x, y, z] = corners[a];
            const double fx = 1 + x * xi[0], fy = 1 + y * xi[1], fz = 1 + z * xi[2];
            g.col(a) = 0.125 * Eigen::Vector3d(x * fy * fz, fx * y * fz, fx * fy * z);
        }
        return g;
    }
};

/// Twenty-node serendipity hexahedron: the corners of Hexa8, then the middles of the edges of the lower face
/// (8-11: 0-1, 1-2, 2-3, 3-0), of the upright edges (12-15: 0-4, 1-5, 2-6, 3-7) and of the upper face (16-19).
///
///     corner  N_a = (1 + sx)(1 + sy)(1 + sz)(sx + sy + sz - 2) / 8,   sx = xi_a xi, ...
///     middle  N_a = (1 - xi^2)(1 + sy)(1 + sz) / 4  for xi_a = 0, and so on
struct Hexa20 {
    using Face = Quad8;
    static constexpr int dimension = 3;
    static constexpr int nodes = 20;
    static constexpr int gauss = 2;
    static constexpr int full_gauss = 3;
    static constexpr int mass_gauss = 3;
    static constexpr bool linear = false;
    static constexpr int pressure_modes = 0;
    static constexpr std::array<std::array<int, 3>, 20> corners{
        {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1},  {1, 1, 1},
         {-1, 1, 1},   {0, -1, -1}, {1, 0, -1}, {0, 1, -1},  {-1, 0, -1}, {-1, -1, 0}, {1, -1, 0},
         {1, 1, 0},    {-1, 1, 0},  {0, -1, 1}, {1, 0, 1},   {0, 1, 1},   {-1, 0, 1}}};
    static constexpr std::array<std::array<int, 8>, 6> faces{{{0, 3, 2, 1, 11, 10, 9, 8},
                                                              {4, 5, 6, 7, 16, 17, 18, 19},
                                                              {0, 1, 5, 4, 8, 13, 16, 12},
                                                              {1, 2, 6, 5, 9, 14, 17, 13},
                                                              {2, 3, 7, 6, 10, 15, 18, 14},
                                                              {3, 0, 4, 7, 11, 12, 19, 15}}};

    static Eigen::Matrix<double, 1, 20> values(const Eigen::Vector3d& xi)
    {
        Eigen::Matrix<double, 1, 20> n;
        for (int a = 0; a < nodes; ++a) {
            double product = a < 8 ? 0.125 : 0.25, sum = -2;
            for (int k = 0; k < 3; ++k) {
                product *= corners[a][k] == 0 ? 1 - xi[k] * xi[k] : 1 + corners[a][k] * xi[k];
                sum += corners[a][k] * xi[k];
            }
            n[a] = a < 8 ? product * sum : product;
        }
        return n;
    }
    static Eigen::Matrix<double, 3, 20> gradients(const Eigen::Vector3d& xi)
    {
        Eigen::Matrix<double, 3, 20> g;
        for (int a = 0; a < nodes; ++a)
            for (int k = 0; k < 3; ++k) g(k, a) = derivative(a, k, xi);
        return g;
    }

private:
    static double derivative(int a, int k, const Eigen::Vector3d& xi)
    {
        double others = a < 8 ? 0.125 : 0.25, sum = -2;
        for (int m = 0; m < 3; ++m) {
            sum += corners[a][m] * xi[m];
            if (m != k) others *= corners[a][m] == 0 ? 1 - xi[m] * xi[m] : 1 + corners[a][m] * xi[m];
        }
        const int s = corners[a][k];
        if (s == 0) return -2 * xi[k] * others;
        return a < 8 ? others * s * (sum + 1 + s * xi[k]) : others * s;
    }
};

} // namespace fem

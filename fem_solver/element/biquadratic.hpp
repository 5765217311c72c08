// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/hexahedra.hpp"

#include <Eigen/Core>

#include <array>

namespace fem {

/// Value and slope at x of the quadratic Lagrange polynomial that is 1 at node s (-1, 0 or 1) and 0 at the other two.
constexpr double lagrange(int s, double x) { return s == 0 ? 1 - x * x : 0.5 * x * (x + s); }
constexpr double lagrange_slope(int s, double x) { return s == 0 ? -2 * x : x + 0.5 * s; }

/// Nine-node quadrilateral: Quad8 and, last, its centre.
///
///     N_a = l_a(xi) l_a(eta),  l quadratic Lagrange polynomials
///
/// With a pressure that is linear in each element it does not lock, up to nu = 0.4999.
struct Quad9 {
    using Face = Line3;
    static constexpr int dimension = 2;
    static constexpr int nodes = 9;
    static constexpr int gauss = 3;
    static constexpr int full_gauss = 3;
    static constexpr int mass_gauss = 3;
    static constexpr bool linear = false;
    static constexpr int pressure_modes = 3;
    static constexpr std::array<std::array<int, 2>, 9> corners{
        {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}}};
    static constexpr std::array<std::array<int, 3>, 4> faces = Quad8::faces;
    /// As the face of a Hexa27: four linear quadrilaterals on the element's own nodes.
    static constexpr std::array<std::array<int, 4>, 4> linear_parts{
        {{0, 4, 8, 7}, {4, 1, 5, 8}, {8, 5, 2, 6}, {7, 8, 6, 3}}};

    static Eigen::Matrix<double, 1, 9> values(const Eigen::Vector2d& xi)
    {
        Eigen::Matrix<double, 1, 9> n;
        for (int a = 0; a < nodes; ++a) n[a] = lagrange(corners[a][0], xi[0]) * lagrange(corners[a][1], xi[1]);
        return n;
    }
    static Eigen::Matrix<double, 2, 9> gradients(const Eigen::Vector2d& xi)
    {
        Eigen::Matrix<double, 2, 9> g;
        for (int a = 0; a < nodes; ++a) {
            const auto [x, y] = corners[a];
            g.col(a) = Eigen::Vector2d(lagrange_slope(x, xi[0]) * lagrange(y, xi[1]),
                                       lagrange(x, xi[0]) * lagrange_slope(y, xi[1]));
        }
        return g;
    }
};

/// Twenty-seven-node hexahedron: Hexa20, then the middles of its faces in the order of `faces`
/// (20-25), then its centre.
struct Hexa27 {
    using Face = Quad9;
    static constexpr int dimension = 3;
    static constexpr int nodes = 27;
    static constexpr int gauss = 3;
    static constexpr int full_gauss = 3;
    static constexpr int mass_gauss = 3;
    static constexpr bool linear = false;
    static constexpr int pressure_modes = 4;
    static constexpr std::array<std::array<int, 3>, 27> corners{
        {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1},  {1, 1, 1},
         {-1, 1, 1},   {0, -1, -1}, {1, 0, -1}, {0, 1, -1},  {-1, 0, -1}, {-1, -1, 0}, {1, -1, 0},
         {1, 1, 0},    {-1, 1, 0},  {0, -1, 1}, {1, 0, 1},   {0, 1, 1},   {-1, 0, 1},  {0, 0, -1},
         {0, 0, 1},    {0, -1, 0},  {1, 0, 0},  {0, 1, 0},   {-1, 0, 0},  {0, 0, 0}}};
    static constexpr std::array<std::array<int, 9>, 6> faces{{{0, 3, 2, 1, 11, 10, 9, 8, 20},
                                                              {4, 5, 6, 7, 16, 17, 18, 19, 21},
                                                              {0, 1, 5, 4, 8, 13, 16, 12, 22},
                                                              {1, 2, 6, 5, 9, 14, 17, 13, 23},
                                                              {2, 3, 7, 6, 10, 15, 18, 14, 24},
                                                              {3, 0, 4, 7, 11, 12, 19, 15, 25}}};

    static Eigen::Matrix<double, 1, 27> values(const Eigen::Vector3d& xi)
    {
        Eigen::Matrix<double, 1, 27> n;
        for (int a = 0; a < nodes; ++a) {
            const auto [x, y, z] = corners[a];
            n[a] = lagrange(x, xi[0]) * lagrange(y, xi[1]) * lagrange(z, xi[2]);
        }
        return n;
    }
    static Eigen::Matrix<double, 3, 27> gradients(const Eigen::Vector3d& xi)
    {
        Eigen::Matrix<double, 3, 27> g;
        for (int a = 0; a < nodes; ++a) {
            const auto [x, y, z] = corners[a];
            const double fx = lagrange(x, xi[0]), fy = lagrange(y, xi[1]), fz = lagrange(z, xi[2]);
            g.col(a) = Eigen::Vector3d(lagrange_slope(x, xi[0]) * fy * fz, fx * lagrange_slope(y, xi[1]) * fz,
                                       fx * fy * lagrange_slope(z, xi[2]));
        }
        return g;
    }
};

} // namespace fem

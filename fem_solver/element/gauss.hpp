// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <vector>

namespace fem {

/// A point of a quadrature rule on [-1, 1]^D and its weight.
template<int D> struct GaussPoint {
    Eigen::Matrix<double, D, 1> xi;
    double weight;
};

/// Gauss-Legendre points and weights on [-1, 1]; n points integrate polynomials of degree 2 n - 1 exactly.
///
/// \param n number of points, 1 to 3.
inline std::vector<GaussPoint<1>> gauss_line(int n)
{
    const double a = 1 / std::sqrt(3.0), b = std::sqrt(0.6);
    const auto point = [](double x, double w) { return GaussPoint<1>{Eigen::Matrix<double, 1, 1>(x), w}; };
    if (n == 1) return {point(0, 2)};
    if (n == 2) return {point(-a, 1), point(a, 1)};
    return {point(-b, 5.0 / 9), point(0, 8.0 / 9), point(b, 5.0 / 9)};
}

/// Tensor product of the Gauss rule with n points per direction, first coordinate fastest.
template<int D> std::vector<GaussPoint<D>> gauss_points(int n)
{
    const auto line = gauss_line(n);
    std::vector<GaussPoint<D>> points;
    int total = 1;
    for (int k = 0; k < D; ++k) total *= n;
    for (int i = 0; i < total; ++i) {
        GaussPoint<D> p{Eigen::Matrix<double, D, 1>::Zero(), 1};
        for (int k = 0, rest = i; k < D; ++k, rest /= n) {
            p.xi[k] = line[rest % n].xi[0];
            p.weight *= line[rest % n].weight;
        }
        points.push_back(p);
    }
    return points;
}

} // namespace fem

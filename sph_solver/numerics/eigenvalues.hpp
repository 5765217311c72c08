// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/vector.hpp"

#include <cmath>
#include <Eigen/Eigenvalues>

namespace sph {

/// True where all eigenvalues of a symmetric matrix exceed a limit (by the minors of A - limit I).
template<int D> bool eigenvalues_exceed(const Mat<D>& a, double limit)
{
    const double x = a(0, 0) - limit, y = a(1, 1) - limit, minor = x * y - a(0, 1) * a(0, 1);
    bool positive = x > 0.0 && minor > 0.0;
    if constexpr (D == 3) {
        const double z = a(2, 2) - limit, xy = a(0, 1), xz = a(0, 2), yz = a(1, 2);
        positive = positive && z * minor - xz * (xz * y - xy * yz) - yz * (yz * x - xy * xz) > 0.0;
    }
    return positive;
}

/// The least eigenvalue of a symmetric matrix.
template<int D> double least_eigenvalue_of(const Mat<D>& a)
{
    if constexpr (D == 2)
        return 0.5 * (a(0, 0) + a(1, 1)) - std::hypot(0.5 * (a(0, 0) - a(1, 1)), a(0, 1));
    else
        return Eigen::SelfAdjointEigenSolver<Mat<D>>().computeDirect(a, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

} // namespace sph

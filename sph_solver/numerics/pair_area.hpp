// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/vector.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <variant>

/// \file
/// The area vector of the face between two particles, a_ij = S (K_i + K_j)/2 n, S = 2 w_i w_j |W'|. The pressure acts on it, and
/// the volumes change with it, dw_i/dt = sum (v_j - v_i)/2 . a_ij: the two stay each other's conjugate whatever K is.
namespace sph {

/// Key "raw": K = I, the kernel's own gradients.
struct RawArea {
    static constexpr bool renormalises = false;
    template<int D> Mat<D> renormaliser(const Mat<D>&) const { return Mat<D>::Identity(); }
};

/// Key "renormalised": K = M^-1 where the neighbourhood is full, so that a linear flow keeps the volumes true and a lattice does
/// not resist shear (docs/theory/fluid.md). Near free surfaces, where M^-1 would feed energy in, K goes over to I:
///
///     K = I + s (M^-1 - I),   s = 3 t^2 - 2 t^3,   t = (lambda - 0.75)/0.2 cut to [0, 1],   lambda least eigenvalue of M
struct RenormalisedArea {
    static constexpr bool renormalises = true;

    template<int D> Mat<D> renormaliser(const Mat<D>& moment) const
    {
        const double t = std::clamp((least_eigenvalue<D>(moment) - 0.75) / 0.2, 0.0, 1.0);
        const Mat<D> identity = Mat<D>::Identity();
        if (t == 0.0) return identity;
        return identity + (t * t * (3.0 - 2.0 * t)) * (moment.inverse() - identity);
    }

private:
    template<int D> static double least_eigenvalue(const Mat<D>& m)
    {
        if constexpr (D == 2)
            return 0.5 * (m(0, 0) + m(1, 1)) - std::hypot(0.5 * (m(0, 0) - m(1, 1)), m(0, 1));
        else
            return Eigen::SelfAdjointEigenSolver<Mat<D>>().computeDirect(m, Eigen::EigenvaluesOnly).eigenvalues()[0];
    }
};

/// The area that a run uses, chosen in setup.
using PairArea = std::variant<RawArea, RenormalisedArea>;

} // namespace sph

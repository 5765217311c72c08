// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/eigenvalues.hpp"

#include <algorithm>
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
        constexpr double none = 0.75, full = 0.95;
        const Mat<D> identity = Mat<D>::Identity();
        if (!eigenvalues_exceed<D>(moment, none)) return identity;
        if (eigenvalues_exceed<D>(moment, full)) return moment.inverse();
        const double t = std::clamp((least_eigenvalue_of<D>(moment) - none) / (full - none), 0.0, 1.0);
        return identity + (t * t * (3.0 - 2.0 * t)) * (moment.inverse() - identity);
    }
};

/// The area that a run uses, chosen in setup.
using PairArea = std::variant<RawArea, RenormalisedArea>;

} // namespace sph

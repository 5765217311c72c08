// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/elastic.hpp"

#include <Eigen/LU>

#include <cmath>

namespace fem {

/// Compressible neo-Hookean law whose volume part is logarithmic (J. C. Simo, K. S. Pister, Comput. Methods Appl. Mech. Engrg
/// 46 (1984) 201); shape and volume are not apart, so it goes without the mixed formulation.
///
///     w = mu/2 (I1 - 3) - mu ln J + lambda/2 ln^2 J,    J = det F > 0,  I1 = F:F (+ 1 in plane strain)
///     P = mu (F - F^-T) + lambda ln J F^-T
struct NeoHookeanLog {
    static constexpr bool finite = true;
    Lame lame;

    double shear_modulus() const { return lame.mu; }

    template<int D> double energy(const Tensor<D>& f) const
    {
        const double i1 = f.squaredNorm() + (3 - D), ln_j = std::log(f.determinant());
        return 0.5 * lame.mu * (i1 - 3) - lame.mu * ln_j + 0.5 * lame.lambda * ln_j * ln_j;
    }
    template<int D> Tensor<D> stress(const Tensor<D>& f) const
    {
        const Tensor<D> h = f.inverse().transpose();
        return lame.mu * (f - h) + lame.lambda * std::log(f.determinant()) * h;
    }
    /// With h = F^-T:
    ///
    ///     dP_ij/dF_kl = mu delta_ik delta_jl + (mu - lambda ln J) h_il h_kj + lambda h_ij h_kl
    template<int D> Tangent<D> tangent(const Tensor<D>& f) const
    {
        const Tensor<D> h = f.inverse().transpose();
        const double q = lame.mu - lame.lambda * std::log(f.determinant());
        return tangent_of<D>([&](int i, int j, int k, int l) {
            return lame.mu * (i == k) * (j == l) + q * h(i, l) * h(k, j) + lame.lambda * h(i, j) * h(k, l);
        });
    }
};

} // namespace fem

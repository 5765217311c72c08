// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/elastic.hpp"

#include <Eigen/LU>

#include <cmath>

namespace fem {

/// Compressible neo-Hookean law with split energy (shape and volume apart).
///
///     w = mu/2 (J^(-2/3) I1 - 3) + K/2 (J - 1)^2,    J = det F > 0,  I1 = F:F (+ 1 in plane strain)
///     P = mu J^(-2/3) (F - I1/3 F^-T) + K (J - 1) J F^-T
///
/// mu and K are those of small strain, so that E and nu may be given.
struct NeoHookean {
    static constexpr bool finite = true;
    Lame lame;

    double shear_modulus() const { return lame.mu; }

    template<int D> double energy(const Tensor<D>& f) const
    {
        const double j = f.determinant(), i1 = first_invariant<D>(f), r = std::cbrt(j);
        return 0.5 * lame.mu * (i1 / (r * r) - 3) + 0.5 * lame.bulk() * (j - 1) * (j - 1);
    }
    template<int D> Tensor<D> stress(const Tensor<D>& f) const
    {
        const double j = f.determinant(), i1 = first_invariant<D>(f), r = std::cbrt(j);
        const double shear = lame.mu / (r * r), pressure = lame.bulk() * (j - 1) * j - shear * i1 / 3;
        return shear * f + pressure * inverse_transposed<D>(f);
    }
    /// With h = F^-T, s = mu J^(-2/3) and q = K (J-1) J - s I1/3:
    ///
    ///     dP_ij/dF_kl = s delta_ik delta_jl - 2/3 s (F_ij h_kl + h_ij F_kl)
    ///                   + (K (2J-1) J + 2/9 s I1) h_ij h_kl - q h_il h_kj
    template<int D> Tangent<D> tangent(const Tensor<D>& f) const
    {
        const double det = f.determinant(), i1 = first_invariant<D>(f), r = std::cbrt(det), bulk = lame.bulk();
        const double s = lame.mu / (r * r), q = bulk * (det - 1) * det - s * i1 / 3;
        const double c = bulk * (2 * det - 1) * det + 2 * s * i1 / 9;
        const Tensor<D> h = inverse_transposed<D>(f);
        return tangent_of<D>([&](int i, int j, int k, int l) {
            return s * (i == k) * (j == l) - 2 * s / 3 * (f(i, j) * h(k, l) + h(i, j) * f(k, l)) +
                   c * h(i, j) * h(k, l) - q * h(i, l) * h(k, j);
        });
    }

private:
    template<int D> static double first_invariant(const Tensor<D>& f) { return f.squaredNorm() + (3 - D); }
    template<int D> static Tensor<D> inverse_transposed(const Tensor<D>& f) { return f.inverse().transpose(); }
};

} // namespace fem

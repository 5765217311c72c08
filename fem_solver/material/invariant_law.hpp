// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/elastic.hpp"

#include <Eigen/LU>

#include <cmath>

namespace fem {

/// Derivatives of an isochoric energy by the first invariant, f' and f'' [Pa].
struct InvariantSlopes {
    double first, second;
};

/// A law whose shape part is a function of the first isochoric invariant alone:
///
///     w = f(I) + K/2 (J - 1)^2,    I = J^(-2/3) I1,   I1 = F:F (+ 1 in plane strain),   J = det F > 0    [J/m^3]
///     P = 2 f' G + K (J - 1) J h,  G = J^(-2/3) (F - I1/3 h) = (dI/dF)/2,   h = F^-T
///
/// `Isochoric` is the energy f: a small struct with energy(excess), slopes(excess) and shear_modulus(), of the excess
/// I - 3 >= 0. No principal directions are needed: see docs/performance.md for what that saves.
template<class Isochoric> struct InvariantLaw {
    static constexpr bool finite = true;
    Isochoric shape;
    double bulk = 0; ///< K [Pa]

    double shear_modulus() const { return shape.shear_modulus(); }

    template<int D> double energy(const Tensor<D>& f) const
    {
        const Invariants<D> at(f);
        return shape.energy(at.excess()) + 0.5 * bulk * (at.j - 1) * (at.j - 1);
    }
    template<int D> Tensor<D> stress(const Tensor<D>& f) const
    {
        const Invariants<D> at(f);
        const double s = 2 * shape.slopes(at.excess()).first * at.scale;
        return s * f + (bulk * (at.j - 1) * at.j - s * at.i1 / 3) * at.h;
    }
    /// With s = 2 f' J^(-2/3) and q = K (J - 1) J - s I1/3:
    ///
    ///     dP_ij/dF_kl = s delta_ik delta_jl - 2/3 s (F_ij h_kl + h_ij F_kl) + 4 f'' G_ij G_kl
    ///                   + (K (2J-1) J + 2/9 s I1) h_ij h_kl - q h_il h_kj
    template<int D> Tangent<D> tangent(const Tensor<D>& f) const
    {
        const Invariants<D> at(f);
        const auto [first, second] = shape.slopes(at.excess());
        const double s = 2 * first * at.scale, q = bulk * (at.j - 1) * at.j - s * at.i1 / 3;
        const double c = bulk * (2 * at.j - 1) * at.j + 2 * s * at.i1 / 9;
        const Tensor<D>& h = at.h;
        const Tensor<D> g = at.scale * (f - at.i1 / 3 * h);
        return tangent_of<D>([&](int i, int j, int k, int l) {
            return s * (i == k) * (j == l) - 2 * s / 3 * (f(i, j) * h(k, l) + h(i, j) * f(k, l)) +
                   4 * second * g(i, j) * g(k, l) + c * h(i, j) * h(k, l) - q * h(i, l) * h(k, j);
        });
    }

private:
    template<int D> struct Invariants {
        double j, i1, scale; // scale = J^(-2/3)
        Tensor<D> h;

        explicit Invariants(const Tensor<D>& f)
            : j(f.determinant()), i1(f.squaredNorm() + (3 - D)), h(f.inverse().transpose())
        {
            const double root = std::cbrt(j);
            scale = 1 / (root * root);
        }
        double excess() const { return scale * i1 - 3; }
    };
};

} // namespace fem

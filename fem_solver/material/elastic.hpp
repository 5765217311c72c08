// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/lame.hpp"

#include <Eigen/Core>

namespace fem {

/// A material is a small struct with its shear_modulus() at small strain [Pa] and three pure functions of the
/// deformation gradient F = I + du/dX: energy(F) [J/m^3], stress(F) = first Piola-Kirchhoff stress P [Pa],
/// tangent(F) = dP/dF [Pa] as a D^2 x D^2 matrix on F's entries in column order. D = 2 means plane strain: F_33 = 1.
template<int D> using Tensor = Eigen::Matrix<double, D, D>;
template<int D> using Tangent = Eigen::Matrix<double, D * D, D * D>;

/// The tangent whose entry dP_ij/dF_kl is component(i, j, k, l).
template<int D, class Component> Tangent<D> tangent_of(Component component)
{
    Tangent<D> a;
    for (int l = 0; l < D; ++l)
        for (int k = 0; k < D; ++k)
            for (int j = 0; j < D; ++j)
                for (int i = 0; i < D; ++i) a(i + D * j, k + D * l) = component(i, j, k, l);
    return a;
}

/// Hooke's law with the small strain eps = sym(F) - I: nothing tells displaced from undisplaced positions.
///
///     w = lambda/2 (tr eps)^2 + mu eps:eps,   P = lambda tr(eps) I + 2 mu eps
struct SmallElastic {
    static constexpr bool finite = false;
    Lame lame;

    double shear_modulus() const { return lame.mu; }

    template<int D> double energy(const Tensor<D>& f) const
    {
        const Tensor<D> e = strain<D>(f);
        return 0.5 * lame.lambda * e.trace() * e.trace() + lame.mu * e.squaredNorm();
    }
    template<int D> Tensor<D> stress(const Tensor<D>& f) const
    {
        const Tensor<D> e = strain<D>(f);
        return lame.lambda * e.trace() * Tensor<D>::Identity() + 2 * lame.mu * e;
    }
    template<int D> Tangent<D> tangent(const Tensor<D>&) const
    {
        return tangent_of<D>([&](int i, int j, int k, int l) {
            return lame.lambda * (i == j) * (k == l) + lame.mu * ((i == k) * (j == l) + (i == l) * (j == k));
        });
    }

private:
    template<int D> static Tensor<D> strain(const Tensor<D>& f)
    {
        return 0.5 * (f + f.transpose()) - Tensor<D>::Identity();
    }
};

/// St. Venant-Kirchhoff: Hooke's law between the Green-Lagrange strain and the second Piola-Kirchhoff stress.
///
///     E = (F^T F - I)/2,   w = lambda/2 (tr E)^2 + mu E:E,   S = lambda tr(E) I + 2 mu E,   P = F S
///
/// For large rotation and small strain; it softens without bound under strong compression.
struct SaintVenantKirchhoff {
    static constexpr bool finite = true;
    Lame lame;

    double shear_modulus() const { return lame.mu; }

    template<int D> double energy(const Tensor<D>& f) const
    {
        const Tensor<D> e = strain<D>(f);
        return 0.5 * lame.lambda * e.trace() * e.trace() + lame.mu * e.squaredNorm();
    }
    template<int D> Tensor<D> stress(const Tensor<D>& f) const { return f * second_stress<D>(f); }
    /// dP_ij/dF_kl = delta_ik S_lj + lambda F_ij F_kl + mu (F_il F_kj + (F F^T)_ik delta_jl)
    template<int D> Tangent<D> tangent(const Tensor<D>& f) const
    {
        const Tensor<D> s = second_stress<D>(f), b = f * f.transpose();
        return tangent_of<D>([&](int i, int j, int k, int l) {
            return (i == k) * s(l, j) + lame.lambda * f(i, j) * f(k, l) +
                   lame.mu * (f(i, l) * f(k, j) + b(i, k) * (j == l));
        });
    }

private:
    template<int D> static Tensor<D> strain(const Tensor<D>& f)
    {
        return 0.5 * (f.transpose() * f - Tensor<D>::Identity());
    }
    template<int D> Tensor<D> second_stress(const Tensor<D>& f) const
    {
        const Tensor<D> e = strain<D>(f);
        return lame.lambda * e.trace() * Tensor<D>::Identity() + 2 * lame.mu * e;
    }
};

} // namespace fem

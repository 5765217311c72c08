// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/invariant_law.hpp"

namespace fem {

/// mu/2 (I - 3).
struct NeoHookeanEnergy {
    double mu = 0; ///< [Pa]

    double shear_modulus() const { return mu; }
    double energy(double excess) const { return 0.5 * mu * excess; }
    InvariantSlopes slopes(double) const { return {0.5 * mu, 0}; }
};

/// Compressible neo-Hookean law with split energy (shape and volume apart).
///
///     w = mu/2 (J^(-2/3) I1 - 3) + K/2 (J - 1)^2
///
/// mu and K are those of small strain, so that E and nu may be given.
struct NeoHookean {
    static constexpr bool finite = true;
    Lame lame;

    double shear_modulus() const { return lame.mu; }
    template<int D> double energy(const Tensor<D>& f) const { return law().energy<D>(f); }
    template<int D> Tensor<D> stress(const Tensor<D>& f) const { return law().stress<D>(f); }
    template<int D> Tangent<D> tangent(const Tensor<D>& f) const { return law().tangent<D>(f); }

private:
    InvariantLaw<NeoHookeanEnergy> law() const { return {{lame.mu}, lame.bulk()}; }
};

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/principal_law.hpp"

#include <vector>

namespace fem {

/// Ogden's energy in terms of the isochoric stretches exp(e_c)
/// (R. W. Ogden, Proc. R. Soc. Lond. A 326 (1972) 565; the moduli here are scaled so that they add up to mu):
///
///     psi = sum_p 2 mu_p / alpha_p^2 (sum_c exp(alpha_p e_c) - 3),     mu = sum_p mu_p
struct OgdenEnergy {
    struct Term {
        double mu;    ///< [Pa]
        double alpha; ///< not zero
    };
    std::vector<Term> terms;

    double shear_modulus() const
    {
        double mu = 0;
        for (const Term& term : terms) mu += term.mu;
        return mu;
    }
    double energy(const Eigen::Vector3d& e) const
    {
        double sum = 0;
        for (const auto& [mu, alpha] : terms)
            for (int c = 0; c < 3; ++c) sum += 2 * mu / (alpha * alpha) * std::expm1(alpha * e[c]);
        return sum;
    }
    LogSlopes slopes(const Eigen::Vector3d& e) const
    {
        LogSlopes s{Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
        for (const auto& [mu, alpha] : terms)
            for (int c = 0; c < 3; ++c) {
                const double power = std::exp(alpha * e[c]);
                s.first[c] += 2 * mu / alpha * power;
                s.second(c, c) += 2 * mu * power;
            }
        return s;
    }
};

using Ogden = PrincipalLaw<OgdenEnergy>;

/// Mooney-Rivlin, psi = c10 (I1 - 3) + c01 (I2 - 3) of the isochoric invariants: Ogden's law with the exponents 2 and
/// -2 and the moduli 2 c10 and 2 c01. \param bulk K [Pa].
inline Ogden mooney_rivlin(double c10, double c01, double bulk)
{
    return {OgdenEnergy{{{2 * c10, 2.0}, {2 * c01, -2.0}}}, bulk};
}

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

namespace fem {

/// Elastic constants of an isotropic solid at small strain.
///
///     mu = E / (2 (1 + nu)),  lambda = E nu / ((1 + nu)(1 - 2 nu)),  K = lambda + 2 mu / 3      [Pa]
struct Lame {
    double mu = 0;
    double lambda = 0;

    double bulk() const { return lambda + 2 * mu / 3; }
    /// \param young E [Pa], positive. \param poisson nu, in (-1, 0.5).
    static Lame from_young(double young, double poisson)
    {
        return {young / (2 * (1 + poisson)), young * poisson / ((1 + poisson) * (1 - 2 * poisson))};
    }
};

/// Bulk modulus that belongs to a shear modulus and Poisson's ratio at small strain.
///
///     K = 2 mu (1 + nu) / (3 (1 - 2 nu))      [Pa]
inline double bulk_modulus(double mu, double poisson) { return 2 * mu * (1 + poisson) / (3 * (1 - 2 * poisson)); }

} // namespace fem

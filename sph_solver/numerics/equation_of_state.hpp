// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/pack.hpp"

#include <cmath>

namespace sph {

/// Tait equation of state of water, gamma = 7; the fluid is barotropic. Below, q = rho / rho0 and e = q - 1.
///
///     p = B (q^7 - 1),   B = rho0 c0^2 / 7,   c = c0 q^3
struct Tait {
    static constexpr double gamma = 7.0;

    double rho0 = 1000.0; ///< reference density [kg/m^3], positive
    double c0 = 10.0;     ///< sound speed at rho0 [m/s], positive

    /// B = rho0 c0^2 / 7 [Pa].
    double stiffness() const { return rho0 * c0 * c0 / gamma; }

    /// Pressure at the density ratio q = rho / rho0 [Pa].
    template<class T> T pressure_at_ratio(T q) const
    {
        const T cube = q * q * q;
        return stiffness() * multiply_add(cube * cube, q, T{} - 1.0);
    }

    /// Pressure from density [Pa]. \param rho [kg/m^3], positive.
    double pressure(double rho) const { return pressure_at_ratio(rho / rho0); }

    /// Sound speed sqrt(dp/drho) = c0 q^3 [m/s].
    double sound_speed(double rho) const
    {
        const double q = rho / rho0;
        return c0 * q * q * q;
    }

    /// Density at a pressure, rho0 (1 + p/B)^(1/7) [kg/m^3]. \param p [Pa], above -B.
    double density(double p) const { return rho0 * std::exp(std::log1p(p / stiffness()) / gamma); }

    /// Specific internal energy u = int p / rho^2 drho [J/kg], zero at rho0.
    ///
    ///     u = c0^2/42 (q^6 - 1) + c0^2/7 (1/q - 1)
    ///       = c0^2 e^2 / 42 [15 + 20 e + 15 e^2 + 6 e^3 + e^4 + 6/(1 + e)]
    ///
    /// The second line is the first one without its cancellation (u is about c0^2 e^2 / 2, far below each term).
    double specific_internal_energy(double rho) const
    {
        const double e = (rho - rho0) / rho0;
        const double polynomial = 15.0 + e * (20.0 + e * (15.0 + e * (6.0 + e)));
        return c0 * c0 * e * e / 42.0 * (polynomial + 6.0 / (1.0 + e));
    }

    /// Specific enthalpy h = u + p/rho = c0^2/6 (q^6 - 1) [J/kg], zero at rho0, without cancellation.
    double specific_enthalpy(double rho) const
    {
        const double e = (rho - rho0) / rho0;
        return c0 * c0 / 6.0 * e * (6.0 + e * (15.0 + e * (20.0 + e * (15.0 + e * (6.0 + e)))));
    }
};

} // namespace sph

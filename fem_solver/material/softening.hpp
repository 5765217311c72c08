// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fem {

/// Damage on unloading, the Mullins effect of filled rubber, by pseudo-elasticity
/// (R. W. Ogden, D. G. Roxburgh, Proc. R. Soc. Lond. A 455 (1999) 2861; beta: Abaqus' form of it):
///
///     P = eta dpsi/dF,   eta = 1 - erf(x)/r,   x = (peak - psi)/s,   s = m + beta peak
///
/// psi is the undamaged law's energy of shape, peak the largest that the point has seen. On the way up peak = psi and eta = 1;
/// on the way down, and up again as far as peak, the stress is smaller. What comes back from psi with the peak held, and
/// what never does:
///
///     stored = integral of eta dpsi from 0 = psi + (s/r) [G(x) - G(x_0)],   x_0 = peak/s
///     lost   = (s/r) G(x_0),            G(x) = integral of erf = x erf(x) + (exp(-x^2) - 1)/sqrt(pi)
///
/// Their sum changes by the work of P alone, up or down, so the books close; what is lost is booked as the peak rises.
struct Softening {
    double r = 0;    ///< at most 1/r of the stress is lost [-]; 0: no softening, else 1 or more
    double m = 0;    ///< [J/m^3], above zero
    double beta = 0; ///< [-]

    bool active() const { return r > 0; }

    struct Factor {
        double value; ///< eta
        double slope; ///< d eta/d psi [m^3/J]
    };
    Factor factor(double psi, double peak) const
    {
        if (psi >= peak) return {1, 0};
        const double x = (peak - psi) / scale(peak);
        return {1 - std::erf(x) / r, 2 * std::numbers::inv_sqrtpi * std::exp(-x * x) / (r * scale(peak))};
    }
    double stored(double psi, double peak) const
    {
        const double top = std::max(psi, peak);
        return psi + scale(top) / r * integral((top - psi) / scale(top)) - lost(top);
    }
    double lost(double peak) const { return scale(peak) / r * integral(peak / scale(peak)); }

private:
    double scale(double peak) const { return m + beta * peak; }
    static double integral(double x) { return x * std::erf(x) + std::numbers::inv_sqrtpi * std::expm1(-x * x); }
};

} // namespace fem

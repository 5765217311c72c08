// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/invariant_law.hpp"
#include "fem_solver/material/uniaxial_curve.hpp"

#include <cmath>
#include <memory>

namespace fem {

/// Energy of the first isochoric invariant I alone, taken from one tension curve
/// (R. S. Marlow, in Constitutive Models for Rubber III, 2003, 157):
///
///     f(I) = work of tension to the stretch l >= 1 with l^2 + 2/l = I
///     f' = m/2,     f'' = m' / (4 (l - l^-2)),   m the curve's secant shear modulus
///
/// Tension of an incompressible body gives back the curve exactly.
struct MarlowEnergy {
    std::shared_ptr<const UniaxialCurve> curve;

    double shear_modulus() const { return curve->shear_modulus(); }
    double energy(double excess) const { return curve->energy(tension(excess)); }
    InvariantSlopes slopes(double excess) const
    {
        const double strain = tension(excess), l = 1 + strain;
        const auto [m, slope] = curve->secant(strain);
        return {0.5 * m, slope == 0 ? 0 : 0.25 * slope / (l - 1 / (l * l))};
    }

private:
    /// Nominal strain e = l - 1 of the tension that has the same I: e^3 + 3 e^2 = (1 + e) (I - 3), by Newton's iteration
    /// from its series in s = sqrt((I - 3)/3), far from rest from s, which lies below the root. It doubles the digits, so a change by
    /// 1e-8 of e is the last one.
    static double tension(double excess)
    {
        if (!(excess > 0)) return 0;
        const double s = std::sqrt(excess / 3);
        double strain = s < 1 ? s * (1 + s / 3 - s * s / 18) : s;
        for (int k = 0; k < 20; ++k) {
            const double square = strain * strain;
            const double change =
                (strain * square + 3 * square - excess * (1 + strain)) / (3 * square + 6 * strain - excess);
            strain -= change;
            if (std::abs(change) <= 1e-8 * strain) break;
        }
        return strain;
    }
};

using Marlow = InvariantLaw<MarlowEnergy>;

} // namespace fem

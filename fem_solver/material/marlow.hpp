// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/principal_law.hpp"
#include "fem_solver/material/uniaxial_curve.hpp"

#include <memory>

namespace fem {

/// Energy of the first isochoric invariant alone, taken from one tension curve
/// (R. S. Marlow, in Constitutive Models for Rubber III, 2003, 157):
///
///     psi = f(I1),  I1 = sum_c exp(2 e_c),   f = work of tension to the stretch l >= 1 with l^2 + 2/l = I1
///     f' = m/2,     f'' = m' / (4 (l - l^-2)),   m the curve's secant shear modulus
///
/// Tension of an incompressible body gives back the curve exactly.
struct MarlowEnergy {
    std::shared_ptr<const UniaxialCurve> curve;

    double shear_modulus() const { return curve->shear_modulus(); }
    double energy(const Eigen::Vector3d& e) const { return curve->energy(tension(e)); }
    LogSlopes slopes(const Eigen::Vector3d& e) const
    {
        const double strain = tension(e), l = 1 + strain;
        const auto [m, slope] = curve->secant(strain);
        const Eigen::Vector3d squares = (2 * e.array()).exp().matrix();
        Eigen::Matrix3d second = (2 * m * squares).asDiagonal();
        if (slope != 0) second += slope / (l - 1 / (l * l)) * squares * squares.transpose(); // 4 f'' sq sq^T
        return {m * squares, second};
    }

private:
    /// Nominal strain l - 1 of the tension that has the same I1: the largest root of l^3 - I1 l + 2 = 0.
    static double tension(const Eigen::Vector3d& e)
    {
        const double excess = std::max(0.0, std::expm1(2 * e[0]) + std::expm1(2 * e[1]) + std::expm1(2 * e[2]));
        const double r = std::sqrt(1 + excess / 3);
        double l = std::max(1.0, 2 * r * std::cos(std::acos(-1 / (r * r * r)) / 3));
        if (const double slope = 3 * l * l - 3 * r * r; slope > 1e-3) l -= (l * (l * l - 3 * r * r) + 2) / slope;
        return std::max(0.0, l - 1);
    }
};

using Marlow = PrincipalLaw<MarlowEnergy>;

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace fem {

/// A measured tension curve of an incompressible body: nominal stress T over nominal strain e = l - 1, through
/// its points.
///
///     T(l) = m(e) (l - l^-2)
///
/// m, the secant shear modulus, is the monotone cubic through its values at the points
/// (F. N. Fritsch, R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238); before the first point and behind the last one
/// it is constant, which is neo-Hookean rubber. So T has a continuous slope and no 0/0 arises at rest.
class UniaxialCurve {
public:
    /// \param strain [-], above zero, ascending. \param stress nominal, above zero [Pa]; as many.
    /// \throws base::Error bad_input naming the point that is wrong.
    UniaxialCurve(std::vector<double> strain, const std::vector<double>& stress);

    struct Secant {
        double value; ///< m [Pa]
        double slope; ///< dm/de [Pa]
    };
    Secant secant(double strain) const;
    /// Work of tension from rest, the integral of T de [J/m^3].
    double energy(double strain) const;
    double shear_modulus() const { return secant_.front(); }
    /// Largest strain measured.
    double last_strain() const { return strain_.back(); }

private:
    double work(double from, double to) const;

    std::vector<double> strain_, secant_, slope_, energy_;
};

} // namespace fem

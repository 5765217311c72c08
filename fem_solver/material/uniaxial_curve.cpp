// SPDX-License-Identifier: MIT
#include "fem_solver/material/uniaxial_curve.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fem {
namespace {

/// l - l^-2 for l = 1 + e.
double tension_factor(double e) { return e * (3 + e * (3 + e)) / ((1 + e) * (1 + e)); }

/// Slopes of the monotone cubic: the weighted harmonic mean of the neighbouring secants, zero at the ends.
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y)
{
    std::vector<double> slopes(x.size(), 0.0);
    for (std::size_t k = 1; k + 1 < x.size(); ++k) {
        const double h0 = x[k] - x[k - 1], h1 = x[k + 1] - x[k];
        const double d0 = (y[k] - y[k - 1]) / h0, d1 = (y[k + 1] - y[k]) / h1;
        if (d0 * d1 > 0) slopes[k] = 3 * (h0 + h1) / ((2 * h1 + h0) / d0 + (h1 + 2 * h0) / d1);
    }
    return slopes;
}

} // namespace

UniaxialCurve::UniaxialCurve(std::vector<double> strain, const std::vector<double>& stress) : strain_(std::move(strain))
{
    base::require_input(!strain_.empty() && strain_.size() == stress.size(), "a tension curve has ", strain_.size(),
                        " strains and ", stress.size(), " stresses; it needs one point at least, and as many of both");
    for (std::size_t k = 0; k < strain_.size(); ++k) {
        base::require_input(strain_[k] > (k > 0 ? strain_[k - 1] : 0), "tension curve, point ", k + 1, ": strain ",
                            strain_[k], " does not ascend; give the nominal strains above zero in ascending order");
        base::require_input(stress[k] > 0, "tension curve, point ", k + 1, ": stress ", stress[k],
                            " Pa is not above zero");
        secant_.push_back(stress[k] / tension_factor(strain_[k]));
    }
    slope_ = monotone_slopes(strain_, secant_);
    energy_.push_back(work(0, strain_.front()));
    for (std::size_t k = 1; k < strain_.size(); ++k)
        energy_.push_back(energy_.back() + work(strain_[k - 1], strain_[k]));
}

auto UniaxialCurve::secant(double strain) const -> Secant
{
    if (strain <= strain_.front()) return {secant_.front(), 0};
    if (strain >= strain_.back()) return {secant_.back(), 0};
    const auto k = std::upper_bound(strain_.begin(), strain_.end(), strain) - strain_.begin() - 1;
    const double h = strain_[k + 1] - strain_[k], t = (strain - strain_[k]) / h;
    const double rise = secant_[k + 1] - secant_[k], a = h * slope_[k] - rise, b = rise - h * slope_[k + 1];
    return {secant_[k] + t * (rise + (1 - t) * (a * (1 - t) + b * t)),
            (rise + (1 - 2 * t) * (a * (1 - t) + b * t) + t * (1 - t) * (b - a)) / h};
}

double UniaxialCurve::energy(double strain) const
{
    const auto k = std::upper_bound(strain_.begin(), strain_.end(), strain) - strain_.begin();
    return k == 0 ? work(0, strain) : energy_[k - 1] + work(strain_[k - 1], strain);
}

/// Gauss's rule of five points on panels so short that the error is below 1e-12; no point lies between the ends.
double UniaxialCurve::work(double from, double to) const
{
    constexpr std::array<double, 3> x{0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 3> w{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const int panels = 1 + static_cast<int>((to - from) / (0.25 * (1 + from)));
    const double half = 0.5 * (to - from) / panels;
    const auto stress = [&](double e) { return secant(e).value * tension_factor(e); };
    double sum = 0;
    for (int k = 0; k < panels; ++k) {
        const double middle = from + (2 * k + 1) * half;
        sum += half * w[0] * stress(middle);
        for (int i = 1; i < 3; ++i) sum += half * w[i] * (stress(middle - half * x[i]) + stress(middle + half * x[i]));
    }
    return sum;
}

} // namespace fem

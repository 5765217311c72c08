// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

namespace base {

/// A quantity at one instant with its derivatives in time.
struct TimeValue {
    double value = 0;        ///< f [unit of f]
    double rate = 0;         ///< df/dt [unit/s]
    double acceleration = 0; ///< d2f/dt2 [unit/s^2]
};

/// A quantity over time t [s].
using TimeFunction = std::function<TimeValue(double)>;

/// f with derivatives by central differences over t - 3 h .. t + 3 h, of sixth order:
///
///     rate:          error h^6 f^(7) / 140,   rounding about 2 eps |f| / h
///     acceleration:  error h^6 f^(8) / 560,   rounding about 4 eps |f| / h^2
///
/// \param step h [s], positive; f must have values on both sides of t.
TimeFunction with_derivatives(std::function<double(double)> f, double step);

/// The natural cubic spline through the points (time, value): its derivatives are exact, the acceleration is continuous
/// and vanishes at both ends. Outside of the points it goes on with the rate of the end.
///
/// \param time [s], ascending, two instants at least; as many values. Throws Error(bad_input) otherwise.
TimeFunction spline_through(std::vector<double> time, std::vector<double> value);

} // namespace base

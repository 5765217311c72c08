// SPDX-License-Identifier: MIT
#include "coupler_lib/base/time_function.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cstddef>

namespace base {
namespace {

struct Spline {
    std::vector<double> time, value;
    std::vector<double> bend; ///< second derivative at the points
};

/// Second derivatives M at the points, from the tridiagonal system of the natural spline (M = 0 at the ends):
///
///     h_(k-1) M_(k-1) + 2 (h_(k-1) + h_k) M_k + h_k M_(k+1) = 6 (slope_k - slope_(k-1))
std::vector<double> natural_bend(const std::vector<double>& t, const std::vector<double>& y)
{
    const std::size_t count = t.size();
    std::vector<double> bend(count, 0.0), upper(count, 0.0);
    const auto slope = [&](std::size_t k) { return (y[k + 1] - y[k]) / (t[k + 1] - t[k]); };
    for (std::size_t k = 1; k + 1 < count; ++k) {
        const double before = t[k] - t[k - 1], after = t[k + 1] - t[k];
        const double pivot = 2 * (before + after) - before * upper[k - 1];
        upper[k] = after / pivot;
        bend[k] = (6 * (slope(k) - slope(k - 1)) - before * bend[k - 1]) / pivot;
    }
    for (std::size_t k = count - 1; k-- > 1;) bend[k] -= upper[k] * bend[k + 1];
    return bend;
}

/// The piece between points k and k + 1, at `s` seconds after point k.
TimeValue on_piece(const Spline& spline, std::size_t k, double s)
{
    const double h = spline.time[k + 1] - spline.time[k];
    const double a = spline.bend[k], b = (spline.bend[k + 1] - a) / h;
    const double slope = (spline.value[k + 1] - spline.value[k]) / h - h * (2 * a + spline.bend[k + 1]) / 6;
    return {spline.value[k] + s * (slope + s * (a / 2 + s * b / 6)), slope + s * (a + s * b / 2), a + s * b};
}

TimeValue value_at(const Spline& spline, double t)
{
    const auto& time = spline.time;
    const double inside = std::clamp(t, time.front(), time.back());
    const auto after = std::upper_bound(time.begin() + 1, time.end() - 1, inside);
    const auto k = static_cast<std::size_t>(after - time.begin()) - 1;
    TimeValue result = on_piece(spline, k, inside - time[k]);
    if (t != inside) result = {result.value + result.rate * (t - inside), result.rate, 0.0};
    return result;
}

} // namespace

TimeFunction with_derivatives(std::function<double(double)> f, double step)
{
    require_input(step > 0, "derivatives need a positive step of time, not ", step, " s");
    return [f = std::move(f), h = step](double t) {
        const double here = f(t);
        const double after[] = {f(t + h), f(t + 2 * h), f(t + 3 * h)};
        const double before[] = {f(t - h), f(t - 2 * h), f(t - 3 * h)};
        const auto odd = [&](int k) { return after[k] - before[k]; };
        const auto even = [&](int k) { return (after[k] - here) + (before[k] - here); };
        return TimeValue{here, (45 * odd(0) - 9 * odd(1) + odd(2)) / (60 * h),
                         (270 * even(0) - 27 * even(1) + 2 * even(2)) / (180 * h * h)};
    };
}

TimeFunction spline_through(std::vector<double> time, std::vector<double> value)
{
    require_input(time.size() >= 2 && time.size() == value.size(),
                  "a curve over time needs two points at least, it has ", time.size(), " times and ", value.size(),
                  " values");
    for (std::size_t k = 1; k < time.size(); ++k) {
        require_input(time[k] > time[k - 1], "the times of a curve must ascend; point ", k + 1, " (", time[k],
                      " s) does not come after ", time[k - 1], " s");
    }
    Spline spline{std::move(time), std::move(value), {}};
    spline.bend = natural_bend(spline.time, spline.value);
    return [spline = std::move(spline)](double t) { return value_at(spline, t); };
}

} // namespace base

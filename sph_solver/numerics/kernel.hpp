// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

#include "sph_solver/numerics/pack.hpp"

namespace sph {

/// Cubic spline kernel of Monaghan (1992) in `D` dimensions, support 2h.
///
///     W(r) = (sigma / h^D) [ (2 - s)^3 - 4 (1 - s)^3 ] / 4,   s = r / h, each bracket cut at zero
///     sigma = 10 / (7 pi) in 2D, 1 / pi in 3D, so that the integral of W over space is 1
template<int D> class CubicSpline {
    static_assert(D == 2 || D == 3);

public:
    /// \param smoothing_length h [m], positive.
    explicit CubicSpline(double smoothing_length)
        : h_(smoothing_length),
          inverse_h_(1.0 / smoothing_length),
          height_(normalisation(smoothing_length)),
          slope_(height_ * inverse_h_)
    {}

    double smoothing_length() const { return h_; }

    /// Radius beyond which the kernel is zero, 2h [m].
    double support() const { return 2.0 * h_; }

    /// W(r) [1/m^D]; r is a distance, not negative.
    double value(double r) const
    {
        const double outer = maximum(2.0 - r * inverse_h_, 0.0);
        const double inner = maximum(1.0 - r * inverse_h_, 0.0);
        return height_ * 0.25 * (outer * outer * outer - 4.0 * inner * inner * inner);
    }

    /// dW/dr [1/m^(D+1)], never positive.
    double derivative(double r) const { return -slope(r); }

    /// |dW/dr| [1/m^(D+1)] without a branch: 3/4 [(2 - s)^2 - (2 - 2 s)^2] sigma / h^(D+1), brackets cut at zero.
    template<class T> T slope(T r) const
    {
        const T two = T{} + 2.0;
        const T outer = maximum(subtract_product(two, r, T{} + inverse_h_), T{});
        const T inner = maximum(subtract_product(two, r, T{} + 2.0 * inverse_h_), T{});
        return (0.75 * slope_) * multiply_add(outer, outer, -(inner * inner));
    }

private:
    static double normalisation(double h)
    {
        if constexpr (D == 2)
            return 10.0 / (7.0 * std::numbers::pi * h * h);
        else
            return 1.0 / (std::numbers::pi * h * h * h);
    }

    double h_, inverse_h_;
    double height_; // sigma / h^D
    double slope_;  // sigma / h^(D+1)
};

} // namespace sph

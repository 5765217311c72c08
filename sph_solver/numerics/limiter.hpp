// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/pack.hpp"

#include <array>
#include <variant>

/// \file
/// Slope limiters of the MUSCL reconstruction. A field f jumps by d = f_j - f_i along a pair, and its gradient at i
/// predicts s = grad f_i . x_ij. The upstream jump is u = 2 s - d. Every limiter here is homogeneous of degree one and
/// symmetric, phi(d, u) = k (d + u) = 2 k s, so all it has to give is the number k:
///
///     f_L = f_i + phi(d, u)/2 = f_i + k s
///
/// k depends on d u and d^2 + u^2 only. Written with dot products it limits a vector as a whole, whatever the frame.
namespace sph {

/// Four quotients for the price of one division, n_k / d_k, as the two fields of a face need them from its two sides
/// (k = 0, 1 and 2, 3): swapping 0 with 1 and 2 with 3 swaps the results, bit by bit.
/// \pre 1e-70 < |d_k| < 1e70, so that the product of all four stays a number.
template<class T>
[[gnu::always_inline]] inline std::array<T, 4> quotients(const std::array<T, 4>& n, const std::array<T, 4>& d)
{
    const T first = d[0] * d[1], second = d[2] * d[3];
    const T inverse = 1.0 / (first * second);
    const T of_first = inverse * second, of_second = inverse * first;
    return {n[0] * (d[1] * of_first), n[1] * (d[0] * of_first), n[2] * (d[3] * of_second), n[3] * (d[2] * of_second)};
}

/// van Albada: phi = d u (d + u) / (d^2 + u^2) where d u > 0, else 0. Second order where the field is smooth; the
/// default.
struct VanAlbada {
    template<class T> T factor(T d_dot_u, T sum_of_squares) const
    {
        return maximum(d_dot_u, T{}) / (sum_of_squares + tiny);
    }
    /// Four of them at once.
    template<class T>
    [[gnu::always_inline]] std::array<T, 4> factors(std::array<T, 4> d_dot_u, std::array<T, 4> sum_of_squares) const
    {
        for (T& product : d_dot_u) product = maximum(product, T{});
        for (T& sum : sum_of_squares) sum = sum + tiny;
        return quotients(d_dot_u, sum_of_squares);
    }

private:
    static constexpr double tiny = 1e-70; // far below the square of any jump's rounding error
};

/// van Leer: phi = 2 d u / (d + u) where d u > 0, else 0. Steeper than van Albada where the two jumps differ: less
/// dissipation, more noise.
struct VanLeer {
    template<class T> T factor(T d_dot_u, T sum_of_squares) const
    {
        const T twice = 2.0 * maximum(d_dot_u, T{});
        return twice / (sum_of_squares + twice + tiny);
    }
    template<class T>
    [[gnu::always_inline]] std::array<T, 4> factors(std::array<T, 4> d_dot_u, std::array<T, 4> sum_of_squares) const
    {
        for (std::size_t k = 0; k < 4; ++k) {
            d_dot_u[k] = 2.0 * maximum(d_dot_u[k], T{});
            sum_of_squares[k] = sum_of_squares[k] + d_dot_u[k] + tiny;
        }
        return quotients(d_dot_u, sum_of_squares);
    }

private:
    static constexpr double tiny = 1e-70;
};

/// No limiter, key "none": the plain linear reconstruction f_L = f_i + s/2. For smooth flows and for studies: it
/// overshoots at jumps.
struct Unlimited {
    template<class T> T factor(T, T) const { return T{} + 0.5; }
    template<class T> std::array<T, 4> factors(const std::array<T, 4>&, const std::array<T, 4>&) const
    {
        return {T{} + 0.5, T{} + 0.5, T{} + 0.5, T{} + 0.5};
    }
};

/// No reconstruction, key "first_order": f_L = f_i. Robust and very dissipative.
struct FirstOrder {
    template<class T> T factor(T, T) const { return T{}; }
    template<class T> std::array<T, 4> factors(const std::array<T, 4>&, const std::array<T, 4>&) const { return {}; }
};

/// The limiter that a run uses, chosen in setup; loops over pairs are compiled for each of them (std::visit).
using Limiter = std::variant<VanAlbada, VanLeer, Unlimited, FirstOrder>;

} // namespace sph

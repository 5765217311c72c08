// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/pack.hpp"

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

/// van Albada: phi = d u (d + u) / (d^2 + u^2) where d u > 0, else 0. Second order where the field is smooth; the
/// default.
struct VanAlbada {
    template<class T> T factor(T d_dot_u, T sum_of_squares) const
    {
        return maximum(d_dot_u, T{}) / (sum_of_squares + 1e-300);
    }
};

/// No limiter, key "none": the plain linear reconstruction f_L = f_i + s/2. For smooth flows and for studies: it
/// overshoots at jumps.
struct Unlimited {
    template<class T> T factor(T, T) const { return T{} + 0.5; }
};

/// No reconstruction, key "first_order": f_L = f_i. Robust and very dissipative.
struct FirstOrder {
    template<class T> T factor(T, T) const { return T{}; }
};

/// The limiter that a run uses, chosen in setup; loops over pairs are compiled for each of them (std::visit).
using Limiter = std::variant<VanAlbada, Unlimited, FirstOrder>;

} // namespace sph

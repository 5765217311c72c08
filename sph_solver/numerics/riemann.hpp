// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/equation_of_state.hpp"
#include "sph_solver/numerics/pack.hpp"

#include <variant>

namespace sph {

/// One side of a face: density and velocity along the face's normal.
struct RiemannState {
    double rho = 0; ///< [kg/m^3]
    double u = 0;   ///< [m/s]
};

/// The state between the two waves. The fluid is barotropic, so density is continuous across the contact: there is
/// one rho, and no upwind side to choose.
struct RiemannSolution {
    double rho = 0; ///< [kg/m^3]
    double u = 0;   ///< [m/s]
    double p = 0;   ///< [Pa]
};

/// The star state in numbers without units: q = rho*/rho0 and u*/c0.
template<class T> struct StarState {
    T q, u;
};

/// The two sides of a face without units: densities over rho0, velocities along the normal over c0.
template<class T> struct FaceStates {
    T q_l, u_l, q_r, u_r;
};

/// Cube without pow.
template<class T> T cube(T x) { return x * x * x; }

/// Exact Godunov solution of the Riemann problem for Tait's fluid, branch-free.
///
/// The wave towards side K changes the velocity by f_K(q), with u* = u_L - f_L(q*) = u_R + f_R(q*):
///
///     rarefaction (q < q_K):  f_K = (q^3 - q_K^3) / 3
///     shock       (q > q_K):  f_K = (q^3 - q_K^3) / 3 + 2/3 (q - q_K)^3
///
/// The shock line is the Rankine-Hugoniot curve sqrt((p - p_K)(1/rho_K - 1/rho)) up to a relative error of
/// delta^6 / 14, delta = q/q_K - 1. (For gamma = 7, with s = sqrt((q^7 - 1)(1 - 1/q) / 7) and q = 1 + delta, the
/// square of delta + delta^2 + delta^3 has the Taylor series of s^2 up to delta^7; other q_K follow by scaling.) So
/// q* is the root of
///
///     G(q) = q^3 - C + (q - q_L)_+^3 + (q - q_R)_+^3,   C = (q_L^3 + q_R^3)/2 + 3/2 (u_L - u_R)
///
/// G without its last two terms is the closed two-rarefaction solution q = C^(1/3). One step of Halley's method takes
/// cube root and shocks together, from the rational approximation of the cube root (Pade [2/1], e = C - 1)
///
///     q = (1 + 8/9 e + 2/27 e^2) / (1 + 5/9 e)
///
/// whose error, of order e^4, comes out cubed. C is kept above `smallest`, short of vacuum.
///
/// Swapping the sides and the signs of both velocities gives the same q and exactly the opposite u.
struct ExactRiemann {
    template<class T> [[gnu::always_inline]] inline StarState<T> operator()(const FaceStates<T>& face) const
    {
        const auto& [q_l, u_l, q_r, u_r] = face;
        const T cube_l = cube(q_l), cube_r = cube(q_r);
        const T c = rarefaction_cube(face, cube_l, cube_r);
        const T q_0 = cube_root_start(c);
        const T b_l = maximum(q_0 - q_l, T{}), b_r = maximum(q_0 - q_r, T{});
        const T s = q_0 * q_0, s_l = b_l * b_l, s_r = b_r * b_r;
        const T g = multiply_add(s, q_0, -c) + (s_l * b_l + s_r * b_r); // G
        const T g1 = s + (s_l + s_r);                                   // G' / 3
        const T g2 = q_0 + (b_l + b_r);                                 // G'' / 6
        const T q = q_0 - g * g1 / multiply_add(3.0 * g1, g1, -(g * g2));
        const T a_l = maximum(q - q_l, T{}), a_r = maximum(q - q_r, T{});
        const T rarefactions = multiply_add(T{} + 1.0 / 6.0, cube_l - cube_r, 0.5 * (u_l + u_r));
        return {q, multiply_add(T{} + 1.0 / 3.0, cube(a_r) - cube(a_l), rarefactions)};
    }

    /// C of the formula above, kept short of vacuum.
    template<class T> [[gnu::always_inline]] static T rarefaction_cube(const FaceStates<T>& face, T cube_l, T cube_r)
    {
        constexpr double smallest = 1e-3;
        return maximum(multiply_add(T{} + 1.5, face.u_l - face.u_r, 0.5 * (cube_l + cube_r)), smallest + T{});
    }

    /// C^(1/3) up to O((C - 1)^4).
    template<class T> [[gnu::always_inline]] static T cube_root_start(T c)
    {
        const T e = c - 1.0;
        const T one = T{} + 1.0;
        return multiply_add(multiply_add(e, T{} + 2.0 / 27.0, T{} + 8.0 / 9.0), e, one) /
               multiply_add(e, T{} + 5.0 / 9.0, one);
    }
};

/// Both waves taken for rarefactions: q* = C^(1/3), the exact solver without its shock terms. Its error is of third order in
/// the shock's strength: 1.6e-3 of the pressure at |u_L - u_R| = 0.1 c0.
struct TwoRarefactionRiemann {
    template<class T> [[gnu::always_inline]] inline StarState<T> operator()(const FaceStates<T>& face) const
    {
        const T cube_l = cube(face.q_l), cube_r = cube(face.q_r);
        const T c = ExactRiemann::rarefaction_cube(face, cube_l, cube_r);
        const T q = ExactRiemann::cube_root_start(c), third = q * q * q;
        return {q * (third + 2.0 * c) / (2.0 * third + c),
                0.5 * (face.u_l + face.u_r) + (1.0 / 6.0) * (cube_l - cube_r)};
    }
};

/// Linear acoustics about the mean state, for comparisons; with q = (q_L + q_R)/2 and c = c0 q^3:
///
///     q* = q + (u_L - u_R) / (2 q^2),     u* = (u_L + u_R)/2 + q^2 (q_L - q_R)/2
///
/// Fails in violent flow: 9 % of the pressure at |u_L - u_R| = 0.1 c0.
struct AcousticRiemann {
    template<class T> [[gnu::always_inline]] inline StarState<T> operator()(const FaceStates<T>& face) const
    {
        const T q = 0.5 * (face.q_l + face.q_r), square = q * q;
        return {q + 0.5 * (face.u_l - face.u_r) / square,
                0.5 * (face.u_l + face.u_r) + 0.5 * square * (face.q_l - face.q_r)};
    }
};

/// The Riemann solver that a run uses, chosen in setup.
using Riemann = std::variant<ExactRiemann, TwoRarefactionRiemann, AcousticRiemann>;

/// The exact Godunov state of two fluid states at the face between them; see ExactRiemann.
///
/// Error of p against the Rankine-Hugoniot solution: below 1e-11 rho0 c0^2 for |u_L - u_R| < 0.06 c0 and below
/// 1e-5 rho0 c0^2 up to 0.5 c0 (tests/sph_solver/numerics/test_riemann.cpp).
inline RiemannSolution solve_riemann(const RiemannState& left, const RiemannState& right, const Tait& eos)
{
    const double mean = 0.5 * (left.u + right.u);
    const auto star = ExactRiemann{}(FaceStates<double>{left.rho / eos.rho0, (left.u - mean) / eos.c0,
                                                        right.rho / eos.rho0, (right.u - mean) / eos.c0});
    return {eos.rho0 * star.q, mean + eos.c0 * star.u, eos.pressure_at_ratio(star.q)};
}

} // namespace sph

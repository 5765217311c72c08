// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "sph_solver/numerics/limiter.hpp"
#include "sph_solver/numerics/riemann.hpp"

namespace sph {

/// A pair as seen from particle i, the numbers that the face between i and j needs. T is `double` or `Pack`.
/// Slopes are the gradients' predictions along the pair, grad f . x_ij.
template<int D, class T> struct PairView {
    std::array<T, D> x;                ///< x_j - x_i [m]
    T inverse_distance;                ///< 1 / |x_ij| [1/m]
    std::array<T, D> velocity_jump;    ///< v_j - v_i [m/s]
    std::array<T, D> mean_velocity;    ///< (v_i + v_j) / 2 [m/s]
    std::array<T, D> velocity_slope_i; ///< grad v_i x_ij [m/s]
    std::array<T, D> velocity_slope_j; ///< grad v_j x_ij [m/s]
};

/// The density of the same pair.
template<class T> struct RatioView {
    T i, j;             ///< q = rho / rho0
    T slope_i, slope_j; ///< grad q . x_ij
};

/// Half the limited jump, phi(d, 2 s - d) / 2 = k s, of a field with jump d and predicted slope s along the pair.
template<class T, class Limiter> [[gnu::always_inline]] inline T half_limited_jump(T jump, T slope, Limiter limiter)
{
    const T upstream = multiply_add(T{} + 2.0, slope, -jump);
    return limiter.factor(jump * upstream, multiply_add(jump, jump, upstream * upstream)) * slope;
}

/// Both sides of the face, reconstructed in (rho, v_n). Velocities are relative to the face, whose own speed
/// is u_b = (v_i + v_j).n / 2, so a common velocity of the pair has no influence at all, not even by rounding.
///
/// \param inverse_c0 1 / c0 [s/m]. \return densities over rho0, velocities over c0.
template<int D, class T, class Limiter>
[[gnu::always_inline]] inline FaceStates<T> reconstruct_face(const PairView<D, T>& pair, const RatioView<T>& q,
                                                             double inverse_c0, Limiter limiter)
{
    const T q_jump = q.j - q.i;
    const T q_l = q.i + half_limited_jump(q_jump, q.slope_i, limiter);
    const T q_r = q.j - half_limited_jump(q_jump, q.slope_j, limiter);

    const T u_jump = dot(pair.velocity_jump, pair.x); // |x_ij| times the normal jump: the limiter scales with it
    const T u_l = half_limited_jump(u_jump, dot(pair.velocity_slope_i, pair.x), limiter) - 0.5 * u_jump;
    const T u_r = 0.5 * u_jump - half_limited_jump(u_jump, dot(pair.velocity_slope_j, pair.x), limiter);
    const T scale = pair.inverse_distance * inverse_c0;
    return {q_l, scale * u_l, q_r, scale * u_r};
}

/// Velocity v_e carried across the face [m/s]: the Riemann velocity along n, the tangential velocity of the side from
/// which the mass comes. The tangential part is limited as a vector, which in 2D is the scalar limiter and in 3D
/// needs no frame.
///
/// \param u u_e - u_b [m/s].
template<int D, class T, class Limiter>
[[gnu::always_inline]] inline std::array<T, D> face_velocity(const PairView<D, T>& pair, T u, Limiter limiter)
{
    const T inverse_square = pair.inverse_distance * pair.inverse_distance;
    std::array<T, D> slope, jump, upstream;
    for (int a = 0; a < D; ++a) slope[a] = select_positive(u, pair.velocity_slope_i[a], pair.velocity_slope_j[a]);
    const T jump_normal = dot(pair.velocity_jump, pair.x) * inverse_square;
    const T slope_normal = dot(slope, pair.x) * inverse_square;
    for (int a = 0; a < D; ++a) {
        jump[a] = multiply_add(-jump_normal, pair.x[a], pair.velocity_jump[a]);
        slope[a] = multiply_add(-slope_normal, pair.x[a], slope[a]);
        upstream[a] = multiply_add(T{} + 2.0, slope[a], -jump[a]);
    }
    const T factor = limiter.factor(dot(jump, upstream), dot(jump, jump) + dot(upstream, upstream));
    const T side = select_positive(u, T{} + 1.0, T{} - 1.0);
    const T normal = u * pair.inverse_distance;
    std::array<T, D> velocity;
    for (int a = 0; a < D; ++a)
        velocity[a] = pair.mean_velocity[a] + (side * (factor * slope[a] - 0.5 * jump[a]) + normal * pair.x[a]);
    return velocity;
}

} // namespace sph

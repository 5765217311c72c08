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
    std::array<T, D> velocity_slope_i; ///< grad v_i x_ij [m/s]
    std::array<T, D> velocity_slope_j; ///< grad v_j x_ij [m/s]
};

/// The part of a vector across the pair. In 2D one number, a . (-x_2, x_1) [m times the unit of a]; in 3D the vector
/// a - (a . x) x / |x|^2. The limiter is homogeneous, so the factor |x| of the 2D form does no harm.
template<int D, class T> using Across = std::array<T, D == 2 ? 1 : 3>;

template<int D, class T>
[[gnu::always_inline]] inline Across<D, T> across(const std::array<T, D>& a, const std::array<T, D>& x,
                                                  T inverse_square)
{
    if constexpr (D == 2) {
        return {multiply_add(x[0], a[1], -(x[1] * a[0]))};
    } else {
        const T along = dot(a, x) * inverse_square;
        return {multiply_add(-along, x[0], a[0]), multiply_add(-along, x[1], a[1]), multiply_add(-along, x[2], a[2])};
    }
}

/// What the velocity carried across the face needs beside the Riemann solution.
template<int D, class T> struct FaceFrame {
    std::array<T, D> x;             ///< x_j - x_i [m]
    T inverse_distance;             ///< 1 / |x_ij| [1/m]
    std::array<T, D> mean_velocity; ///< (v_i + v_j) / 2 [m/s]
    Across<D, T> jump;              ///< of the velocity
    Across<D, T> slope_i, slope_j;  ///< of the velocity
};

/// The density of the same pair.
template<class T> struct RatioView {
    T i, j;             ///< q = rho / rho0
    T slope_i, slope_j; ///< grad q . x_ij
};

/// Both sides of the face, reconstructed in (rho, v_n): f_L = f_i + k_i s_i, f_R = f_j - k_j s_j. Velocities are
/// relative to the face, whose own speed is u_b = (v_i + v_j).n / 2, so a common velocity of the pair has no influence
/// at all, not even by rounding.
///
/// \param inverse_c0 1 / c0 [s/m]. \return densities over rho0, velocities over c0.
template<int D, class T, class Limiter>
[[gnu::always_inline]] inline FaceStates<T> reconstruct_face(const PairView<D, T>& pair, const RatioView<T>& q,
                                                             double inverse_c0, Limiter limiter)
{
    const T q_jump = q.j - q.i;
    const T u_jump = dot(pair.velocity_jump, pair.x); // |x_ij| times the normal jump: the limiter scales with it
    const std::array<T, 4> jump = {q_jump, q_jump, u_jump, u_jump};
    const std::array<T, 4> slope = {q.slope_i, q.slope_j, dot(pair.velocity_slope_i, pair.x),
                                    dot(pair.velocity_slope_j, pair.x)};
    std::array<T, 4> product, squares;
    for (std::size_t k = 0; k < 4; ++k) {
        const T upstream = multiply_add(T{} + 2.0, slope[k], -jump[k]);
        product[k] = jump[k] * upstream;
        squares[k] = multiply_add(jump[k], jump[k], upstream * upstream);
    }
    const auto factor = limiter.factors(product, squares);
    const T scale = pair.inverse_distance * inverse_c0;
    const T half_jump = 0.5 * u_jump;
    return {multiply_add(factor[0], slope[0], q.i), scale * multiply_add(factor[2], slope[2], -half_jump),
            subtract_product(q.j, factor[1], slope[1]), scale * subtract_product(half_jump, factor[3], slope[3])};
}

/// The frame of the same face. \param mean_velocity (v_i + v_j) / 2 [m/s]
template<int D, class T>
[[gnu::always_inline]] inline FaceFrame<D, T> face_frame(const PairView<D, T>& pair,
                                                         const std::array<T, D>& mean_velocity)
{
    const T inverse_square = pair.inverse_distance * pair.inverse_distance;
    return {pair.x,
            pair.inverse_distance,
            mean_velocity,
            across<D, T>(pair.velocity_jump, pair.x, inverse_square),
            across<D, T>(pair.velocity_slope_i, pair.x, inverse_square),
            across<D, T>(pair.velocity_slope_j, pair.x, inverse_square)};
}

/// Velocity v_e carried across the face [m/s]: the Riemann velocity along n, the tangential velocity of the side from
/// which the mass comes. The tangential part is limited as a vector, which in 2D is the scalar limiter and in 3D
/// needs no frame.
///
/// \param u u_e - u_b [m/s].
template<int D, class T, class Limiter>
[[gnu::always_inline]] inline std::array<T, D> face_velocity(const FaceFrame<D, T>& face, T u, Limiter limiter)
{
    Across<D, T> slope, upstream;
    for (std::size_t a = 0; a < slope.size(); ++a) {
        slope[a] = select_positive(u, face.slope_i[a], face.slope_j[a]);
        upstream[a] = multiply_add(T{} + 2.0, slope[a], -face.jump[a]);
    }
    const T factor = limiter.factor(dot(face.jump, upstream), dot(face.jump, face.jump) + dot(upstream, upstream));
    const T side = select_positive(u, T{} + 1.0, T{} - 1.0);
    const T normal = u * face.inverse_distance;
    Across<D, T> tangential;
    for (std::size_t a = 0; a < slope.size(); ++a)
        tangential[a] = side * multiply_add(factor, slope[a], -0.5 * face.jump[a]);
    if constexpr (D == 2) {
        const T turned = tangential[0] * (face.inverse_distance * face.inverse_distance);
        return {multiply_add(normal, face.x[0], subtract_product(face.mean_velocity[0], turned, face.x[1])),
                multiply_add(normal, face.x[1], multiply_add(turned, face.x[0], face.mean_velocity[1]))};
    } else {
        return {multiply_add(normal, face.x[0], face.mean_velocity[0] + tangential[0]),
                multiply_add(normal, face.x[1], face.mean_velocity[1] + tangential[1]),
                multiply_add(normal, face.x[2], face.mean_velocity[2] + tangential[2])};
    }
}

} // namespace sph

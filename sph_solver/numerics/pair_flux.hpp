// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/muscl.hpp"
#include "sph_solver/numerics/vector.hpp"

namespace sph {

/// One particle, or one ghost, as the flux of a pair sees it.
template<int D> struct PrimitiveState {
    double density = 0;                        ///< rho [kg/m^3], positive
    Vec<D> velocity = Vec<D>::Zero();          ///< v [m/s]
    Vec<D> density_gradient = Vec<D>::Zero();  ///< grad rho [kg/m^4]
    Mat<D> velocity_gradient = Mat<D>::Zero(); ///< (grad v)(a, b) = d v_a / d x_b [1/s]
};

/// What crosses the face between i and j, towards j, for each unit of S = 2 w_i w_j |dW/dr| [m^(D-1)]:
///
///     dm_i -= S mass_flux,   dP_i -= S (momentum_flux + pressure n),   n = x_ij / |x_ij|;   j gets the opposite
template<int D> struct PairFlux {
    double mass_flux = 0;                  ///< rho_e (u_e - u_b) [kg/(m^2 s)]
    Vec<D> momentum_flux = Vec<D>::Zero(); ///< mass_flux v_e [Pa]
    double pressure = 0;                   ///< p_e [Pa]
};

/// Flux between two particles: MUSCL reconstruction in the pair's frame, then the exact Riemann problem at a face
/// that moves with u_b = (v_i + v_j).n / 2 (docs/theory/fluid.md). The pair seen from j gives exactly the opposite,
/// bit by bit.
///
/// \param x_ij x_j - x_i [m], not zero.
/// \param wall true: no mass crosses the face, which leaves the pressure alone (mass_flux = 0, momentum_flux = 0).
template<int D, class Limiter>
PairFlux<D> pair_flux(const PrimitiveState<D>& left, const PrimitiveState<D>& right, const Vec<D>& x_ij,
                      const Tait& eos, Limiter limiter, bool wall)
{
    PairView<D, double> pair;
    std::array<double, D> mean_velocity;
    const Vec<D> slope_left = left.velocity_gradient * x_ij;
    const Vec<D> slope_right = right.velocity_gradient * x_ij;
    for (int a = 0; a < D; ++a) {
        pair.x[a] = x_ij[a];
        pair.velocity_jump[a] = right.velocity[a] - left.velocity[a];
        mean_velocity[a] = 0.5 * (left.velocity[a] + right.velocity[a]);
        pair.velocity_slope_i[a] = slope_left[a];
        pair.velocity_slope_j[a] = slope_right[a];
    }
    pair.inverse_distance = 1.0 / square_root(dot(pair.x, pair.x));
    const RatioView<double> q{left.density / eos.rho0, right.density / eos.rho0,
                              left.density_gradient.dot(x_ij) / eos.rho0, right.density_gradient.dot(x_ij) / eos.rho0};

    const StarState<double> star = ExactRiemann{}(reconstruct_face(pair, q, 1.0 / eos.c0, limiter));
    PairFlux<D> flux;
    flux.pressure = eos.pressure_at_ratio(star.q);
    if (wall) return flux;
    const double u = eos.c0 * star.u;
    const auto velocity = face_velocity(face_frame<D>(pair, mean_velocity), u, limiter);
    flux.mass_flux = eos.rho0 * star.q * u;
    for (int a = 0; a < D; ++a) flux.momentum_flux[a] = flux.mass_flux * velocity[a];
    return flux;
}

} // namespace sph

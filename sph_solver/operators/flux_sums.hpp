// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/vector.hpp"

#include <vector>

namespace sph {

/// The neighbour sums of pass 2 for one owned particle over its fluid pairs, the two causes of momentum kept apart
/// because each has its own column in the energy ledger. S = 2 w_i w_j |W'|:
///
///     mass = -sum S mf,   by_mass = -sum S mf v_e,   by_pressure = -sum S p_e n,   swept = sum S u_shift,
///     dilation = sum (v_j - v_i)/2 . a_ij + S u_fluid,   a_ij = S n or renormalised (numerics/pair_area.hpp)
///
/// The dilation is the conjugate of the pressure, face by face. u_shift and u_fluid are what the faces' own motion sweeps
/// (numerics/face_motion.hpp); the second belongs to the compression.
template<int D> struct FluxSums {
    double mass = 0;                     ///< dm/dt [kg/s]
    Vec<D> by_mass = Vec<D>::Zero();     ///< dP/dt carried by the mass flux [N]
    Vec<D> by_pressure = Vec<D>::Zero(); ///< dP/dt of the pressure [N]
    double dilation = 0;                 ///< dw/dt by compression [m^D/s]
    double swept = 0;                    ///< dw/dt by faces that follow shifted particles [m^D/s]
};

/// Row k belongs to the k-th owned particle, as in ReachedNeighbours.
template<int D> using FluxField = std::vector<FluxSums<D>>;

} // namespace sph

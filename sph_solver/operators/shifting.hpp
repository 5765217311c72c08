// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/operators/gradient_sums.hpp"
#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "sph_solver/operators/pair_records.hpp"
#include "sph_solver/walls/walls.hpp"

namespace sph {

/// Particle shifting: a velocity beside the fluid's that evens out the distances between particles. What the particles
/// leave behind crosses the faces between them (numerics/face_motion.hpp, ShiftedMotion), so mass, momentum and the
/// energy ledger stay whole (Oger, Marrone, Le Touze and de Leffe 2016; here with a magnitude of its own):
///
///     v_s,i = -min(beta h |D_i|, c0/2) h grad C_i,   grad C_i = sum w_j grad W,   |D| = sqrt(2 D:D),
///     D = (grad v + grad v^T)/2
///
/// A displacement of one particle decays about beta times in the time 1/|D|. The speed is the same for every observer and
/// vanishes at rest and in rigid motion; |h grad C| is taken for 0.2 at most. Particles next to a free surface (smallest
/// eigenvalue of M below 0.75) and next to walls are left alone: there grad C has another cause.
/// \pre gradients of the owned particles and `sums` are complete. With another face motion nothing is shifted.
template<int D>
void find_shifts(Particles<D>& particles, const PairRecords<D>& records, const ReachedNeighbours& neighbours,
                 const GradientField<D>& sums, const Walls<D>& walls, const FluidModel<D>& model);

} // namespace sph

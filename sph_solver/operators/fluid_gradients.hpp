// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/operators/gradient_sums.hpp"
#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "sph_solver/operators/pair_records.hpp"
#include "sph_solver/state/particles.hpp"

/// \file
/// Pass 1 over the neighbours, in three calls so that walls can add their images in between:
///
///     accumulate_fluid_gradients(sums, ...);   accumulate_wall_gradients(sums, ...);   finish_gradients(...);
namespace sph {

/// Makes `sums` anew: the sums of GradientSums over the fluid pairs of each owned particle, neighbours in the list's
/// order, for the given rows.
/// \pre records.load_states was called for the present state.
template<int D>
void accumulate_fluid_gradients(GradientField<D>& sums, const PairRecords<D>& records,
                                const ReachedNeighbours& neighbours, const RowSet& rows, const FluidModel<D>& model);

/// Gradients of owned particles and the rate of their volumes from the complete sums:
///
///     grad f = 0          in drops and threads of a particle's thickness (fluid_fill below 1/3),
///              G[f] M^-1  elsewhere where the smallest eigenvalue of M exceeds 0.2,  else G[f]
template<int D>
void finish_gradients(Particles<D>& particles, const GradientField<D>& sums, const FluidModel<D>& model);

/// M may be inverted where its smallest eigenvalue exceeds this.
inline constexpr double least_eigenvalue = 0.2;

/// Fewer neighbours than this make no gradient: what a few particles do among themselves is linear in space to the last
/// digit, so it would not be damped, and an explicit step of second order feeds it (docs/theory/fluid.md).
inline constexpr double thread_fill = 1.0 / 3.0;

} // namespace sph

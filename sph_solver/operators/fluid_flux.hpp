// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/operators/flux_sums.hpp"
#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "sph_solver/operators/pair_records.hpp"
#include "sph_solver/state/particles.hpp"

#include <cstddef>
#include <span>

namespace sph {

/// Pass 2 over the neighbours: mass and momentum that each owned particle gets from its fluid pairs, MUSCL and exact
/// Riemann solver at a face half-way (numerics/pair_flux.hpp), with S = 2 w_i w_j |W'|:
///
///     dm_i/dt = -sum S mf,   dP_i/dt = -sum S (mf v_e + p_e n),   dw_i/dt += sum S u_face
///
/// A face between two particles of the given rows is solved once (FaceBatch); the pair seen from the other side gives
/// the exactly opposite flux, and sums keep their order, so that results do not depend on which rows are given or on the
/// partition. Adds to `rates` and makes `sums` anew, for the given rows.
/// \param scratch memory that nobody needs now, to sum in
/// \pre records hold states and slopes of the present state; rows ascend.
template<int D>
void add_fluid_fluid_flux(Rates<D>& rates, FluxField<D>& sums, const PairRecords<D>& records,
                          const ReachedNeighbours& neighbours, const RowSet& rows, const FluidModel<D>& model,
                          std::span<std::byte> scratch = {});

/// Weight of each owned particle, dP_i/dt += m_i g [N].
template<int D> void add_gravity(Rates<D>& rates, const Particles<D>& particles, const Vec<D>& gravity);

} // namespace sph

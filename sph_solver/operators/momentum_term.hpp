// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/row_set.hpp"
#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "sph_solver/operators/pair_records.hpp"
#include "sph_solver/operators/wall_flux.hpp"

#include <vector>

namespace sph {

/// A further force between particles, beside the fluxes of the method: chosen in setup, called in the second pass.
template<int D> class MomentumTerm {
public:
    virtual ~MomentumTerm() = default;

    /// Adds the force on each particle of some rows by its fluid pairs to `rates.momentum`, and to `sums` (one entry for
    /// each owned particle, zero before) for the energy ledger.
    /// \pre records hold the present states
    virtual void add(Rates<D>& rates, std::vector<Vec<D>>& sums, const PairRecords<D>& records,
                     const ReachedNeighbours& neighbours, const RowSet& rows) const = 0;

    /// Adds the force of the images to that of the walls' pressure, on particles and on walls.
    /// \pre find_wall_forces has made `forces`
    virtual void add_at_walls(WallForces<D>& forces, const WallImages<D>& images, const Walls<D>& walls,
                              const PairRecords<D>& records) const = 0;
};

} // namespace sph

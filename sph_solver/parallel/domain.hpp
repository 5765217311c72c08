// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"
#include "coupler_lib/foundation/scatter.hpp"
#include "sph_solver/parallel/balance.hpp"
#include "sph_solver/parallel/block_map.hpp"
#include "sph_solver/state/canonical_order.hpp"
#include "sph_solver/state/particles.hpp"

#include <map>
#include <span>
#include <vector>

namespace sph {

/// The fluid spread over the ranks: who owns which particle and who needs copies of it.
///
/// Space is divided into blocks, the cells of the canonical order; each occupied one has one owner, found by cutting the
/// weighted graph of blocks. A particle belongs to the owner of its block. Halo copies are all foreign particles within `reach` of a
/// block of mine. Every particle's neighbours thus are present where it is owned, in the one canonical order, and
/// results do not depend on the cut.
template<int D> class Domain {
public:
    /// \param grid the neighbour search's grid: its cells, `reach` wide, define the canonical order
    Domain(const base::Communicator& comm, const CellGrid<D>& grid, const RebalanceSettings& settings = {});

    /// Sends every particle to its owner, then makes the halo copies and sorts everything canonically. Collective.
    ///
    /// \pre conserved fields of the owned particles are valid; where they lie and in which order does not matter
    /// \post conserved fields of all local particles are valid; derived fields have entries, but must be recomputed;
    ///       `owned`, `is_owned` and the scatter are new, neighbour lists are void
    void redistribute(Particles<D>& particles);

    /// Sends position, volume, mass and momentum of the owned particles on their way to the halo copies. Collective.
    void start_state(const Particles<D>& particles);
    /// Waits for them, if they are on their way, and puts them in place. One exchange at a time.
    void finish_state(Particles<D>& particles);

    /// The same for the gradients of density and velocity.
    void start_gradients(const Particles<D>& particles) const;
    void finish_gradients(Particles<D>& particles) const;

    /// Tells what work there is before particles are spread anew: the cost [s] of each owned particle is the weight of
    /// the next cut, what this rank has measured since the last call [s] decides whether there is one. Collective.
    void record_work(const Particles<D>& particles, std::span<const double> costs, double measured);

    [[nodiscard]] const base::Communicator& comm() const { return comm_; }
    [[nodiscard]] const base::Scatter& scatter() const { return scatter_; }
    [[nodiscard]] const BlockMap<D>& blocks() const { return blocks_; }
    [[nodiscard]] const Balance& balance() const { return balance_; }
    /// Fewest particles that this rank has owned after any redistribution.
    [[nodiscard]] std::size_t least_owned() const { return least_owned_; }

private:
    void sort_alone(Particles<D>& particles);
    void update_blocks(const Particles<D>& particles);
    [[nodiscard]] std::vector<BlockWork> with_recorded_work(const std::map<CellKey, std::int64_t>& counts) const;
    void migrate(Particles<D>& particles);
    void exchange_halo(Particles<D>& particles);
    [[nodiscard]] std::vector<std::vector<int>> halo_for_ranks(const Particles<D>& particles) const;
    [[nodiscard]] bool within_reach(const Vec<D>& x, CellKey block) const;
    void make_scatter(const std::vector<std::vector<int>>& sent, const std::vector<int>& received,
                      const std::vector<int>& new_index);

    base::Communicator comm_;
    CellGrid<D> cells_;
    BlockMap<D> blocks_;
    Balance balance_;
    base::Scatter scatter_;
    bool state_travels_ = false;
    std::size_t blocks_at_attempt_ = 0;    ///< blocks after the last attempt to cut
    std::map<CellKey, std::int64_t> work_; ///< of my blocks [ps], from the last record_work
    std::size_t least_owned_ = static_cast<std::size_t>(-1);
    std::int64_t mean_work_ = 1; ///< of a particle, over all ranks [ps]
};

} // namespace sph

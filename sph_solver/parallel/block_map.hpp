// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/parallel/partition.hpp"
#include "sph_solver/state/cell_grid.hpp"

#include <array>
#include <span>
#include <vector>

namespace sph {

/// Work in one block, as one rank sees it.
struct BlockWork {
    CellKey block;
    std::int64_t work;
    std::int64_t rank;
};

/// Which rank owns which block of space; the same on every rank.
template<int D> class BlockMap {
public:
    static constexpr int unknown = -1;

    /// \param block_size edge of a block [m], at least the reach of the neighbour search
    explicit BlockMap(double block_size) : grid_(block_size) {}

    [[nodiscard]] const CellGrid<D>& grid() const { return grid_; }
    [[nodiscard]] bool empty() const { return blocks_.empty(); }
    [[nodiscard]] std::size_t size() const { return blocks_.size(); }

    /// Rank that owns the block, `unknown` for one that has never held a particle.
    [[nodiscard]] int owner(CellKey block) const;

    /// Cuts all blocks that hold particles anew, if that lowers the imbalance (largest work of a rank over the mean) by
    /// `gain` or a block has no owner yet; else all keep their owners. Blocks without particles are forgotten. `mine`: the
    /// work in the blocks of this rank's particles; several ranks may name the same block. \return whether owners have
    /// changed. Collective.
    bool repartition(const base::Communicator& comm, const std::vector<BlockWork>& mine, double gain);

    /// Gives blocks that particles have just entered to the rank that has most of them. Collective.
    void adopt(const base::Communicator& comm, const std::vector<BlockWork>& entered);

private:
    [[nodiscard]] static WeightedGraph graph(const std::vector<CellKey>& blocks, const std::vector<std::int64_t>& work);
    [[nodiscard]] static std::vector<int> better_owners(const WeightedGraph& graph, const std::vector<int>& old,
                                                        int ranks, double gain);
    void insert(const std::vector<CellKey>& blocks, const std::vector<int>& owners);

    CellGrid<D> grid_;
    std::vector<CellKey> blocks_; ///< ascending
    std::vector<int> owners_;
};

/// Calls visit(key) for the 3^D - 1 blocks around one, ascending.
template<int D, class Visitor> void for_each_adjacent(CellKey block, Visitor&& visit)
{
    const auto centre = CellGrid<D>::cell(block);
    constexpr int count = D == 2 ? 9 : 27;
    for (int n = 0; n < count; ++n) {
        if (n == count / 2) continue;
        auto cell = centre;
        for (int d = 0, rest = n; d < D; ++d, rest /= 3) cell[static_cast<std::size_t>(d)] += rest % 3 - 1;
        visit(CellGrid<D>::key(cell));
    }
}

} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/parallel/block_map.hpp"

#include <algorithm>
#include <numeric>

namespace sph {
namespace {

/// Everybody's work, sorted by block, then by falling work, then by rank.
std::vector<BlockWork> gather_sorted(const base::Communicator& comm, const std::vector<BlockWork>& mine)
{
    std::vector<BlockWork> all = comm.gather_all(mine);
    std::sort(all.begin(), all.end(), [](const BlockWork& a, const BlockWork& b) {
        if (a.block != b.block) return a.block < b.block;
        return a.work != b.work ? a.work > b.work : a.rank < b.rank;
    });
    return all;
}

} // namespace

template<int D> int BlockMap<D>::owner(CellKey block) const
{
    const auto found = std::lower_bound(blocks_.begin(), blocks_.end(), block);
    if (found == blocks_.end() || *found != block) return unknown;
    return owners_[static_cast<std::size_t>(found - blocks_.begin())];
}

template<int D>
bool BlockMap<D>::repartition(const base::Communicator& comm, const std::vector<BlockWork>& mine, double gain)
{
    std::vector<CellKey> blocks;
    std::vector<std::int64_t> work;
    for (const BlockWork& entry : gather_sorted(comm, mine)) {
        if (blocks.empty() || blocks.back() != entry.block) {
            blocks.push_back(entry.block);
            work.push_back(0);
        }
        work.back() += entry.work;
    }
    std::vector<int> old(blocks.size());
    std::transform(blocks.begin(), blocks.end(), old.begin(), [this](CellKey block) { return owner(block); });
    // One rank cuts and tells the others, so that the answer is one even where libraries differ.
    owners_ = comm.gather_all(comm.is_root() ? better_owners(graph(blocks, work), old, comm.size(), gain)
                                             : std::vector<int>{});
    blocks_.swap(blocks);
    return owners_ != old;
}

/// A new cut, or the old one where that is good enough.
template<int D>
std::vector<int> BlockMap<D>::better_owners(const WeightedGraph& graph, const std::vector<int>& old, int ranks,
                                            double gain)
{
    const std::vector<std::int64_t>& work = graph.vertex_weights;
    std::vector<int> cut = keep_owners(partition(graph, ranks), old, work, ranks);
    const bool all_owned = std::find(old.begin(), old.end(), unknown) == old.end();
    return all_owned && imbalance(cut, work, ranks) > imbalance(old, work, ranks) - gain ? old : cut;
}

template<int D> void BlockMap<D>::adopt(const base::Communicator& comm, const std::vector<BlockWork>& entered)
{
    std::vector<CellKey> blocks;
    std::vector<int> owners;
    for (const BlockWork& entry : gather_sorted(comm, entered)) {
        if (!blocks.empty() && blocks.back() == entry.block) continue;
        blocks.push_back(entry.block);
        owners.push_back(static_cast<int>(entry.rank));
    }
    if (!blocks.empty()) insert(blocks, owners);
}

/// Blocks as vertices; edges to the blocks that touch them, the more costly to cut the larger the shared face and the
/// more work lies on both sides of it.
template<int D>
WeightedGraph BlockMap<D>::graph(const std::vector<CellKey>& blocks, const std::vector<std::int64_t>& work)
{
    WeightedGraph graph;
    graph.vertex_weights = work;
    std::int64_t largest = 1;
    for (const std::int64_t amount : work) largest = std::max(largest, amount);
    for (std::size_t v = 0; v < blocks.size(); ++v) {
        const auto centre = CellGrid<D>::cell(blocks[v]);
        for_each_adjacent<D>(blocks[v], [&](CellKey other) {
            const auto found = std::lower_bound(blocks.begin(), blocks.end(), other);
            if (found == blocks.end() || *found != other) return;
            const auto u = static_cast<std::size_t>(found - blocks.begin());
            const auto cell = CellGrid<D>::cell(other);
            int differing = 0;
            for (std::size_t d = 0; d < D; ++d) differing += cell[d] != centre[d] ? 1 : 0;
            const std::int64_t face = differing == 1 ? 100 : differing == 2 ? 25 : 6;
            graph.adjacency.push_back(static_cast<std::int64_t>(u));
            graph.edge_weights.push_back(1 + face * std::min(work[u], work[v]) / largest);
        });
        graph.offsets.push_back(static_cast<std::int64_t>(graph.adjacency.size()));
    }
    return graph;
}

template<int D> void BlockMap<D>::insert(const std::vector<CellKey>& blocks, const std::vector<int>& owners)
{
    std::vector<CellKey> merged;
    std::vector<int> merged_owners;
    std::size_t a = 0;
    std::size_t b = 0;
    while (a < blocks_.size() || b < blocks.size()) {
        const bool from_old = b == blocks.size() || (a < blocks_.size() && blocks_[a] < blocks[b]);
        merged.push_back(from_old ? blocks_[a] : blocks[b]);
        merged_owners.push_back(from_old ? owners_[a++] : owners[b++]);
    }
    blocks_.swap(merged);
    owners_.swap(merged_owners);
}

template class BlockMap<2>;
template class BlockMap<3>;

} // namespace sph

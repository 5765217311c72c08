// SPDX-License-Identifier: MIT
#include "sph_solver/parallel/domain.hpp"

#include "coupler_lib/foundation/exchange.hpp"
#include "sph_solver/parallel/packing.hpp"

#include <algorithm>
#include <map>

namespace sph {
namespace {

constexpr double cells_per_block = 2.0;

std::vector<BlockWork> as_list(const std::map<CellKey, std::int64_t>& work, int rank)
{
    std::vector<BlockWork> list;
    for (const auto& [block, amount] : work) list.push_back({block, amount, rank});
    return list;
}

} // namespace

template<int D>
Domain<D>::Domain(const base::Communicator& comm, const CellGrid<D>& grid, const RebalanceSettings& settings)
    : comm_(comm), cells_(grid), blocks_(cells_per_block * grid.cell_size()), settings_(settings)
{}

template<int D> void Domain<D>::redistribute(Particles<D>& particles)
{
    if (comm_.size() == 1) return sort_alone(particles);
    drop_halo(particles);
    update_blocks(particles);
    migrate(particles);
    exchange_halo(particles);
}

template<int D> void Domain<D>::sort_alone(Particles<D>& particles) { sort_canonically(particles, cells_); }

/// Every block with particles has an owner afterwards: by a new cut when there is none yet or the work has become too
/// uneven, else by giving newly entered blocks away.
template<int D> void Domain<D>::update_blocks(const Particles<D>& particles)
{
    ++rebuilds_since_cut_;
    const bool cut = blocks_.empty() || unbalanced();
    std::map<CellKey, std::int64_t> found;
    for (const Vec<D>& x : particles.position) {
        const CellKey block = blocks_.grid().key_of(x);
        if (cut || blocks_.owner(block) == BlockMap<D>::unknown) found[block] += 1;
    }
    if (!cut) return blocks_.adopt(comm_, as_list(found, comm_.rank()));
    for (const BlockWork& measured : work_) {
        const auto here = found.find(measured.block);
        if (here != found.end()) here->second = measured.work;
    }
    blocks_.repartition(comm_, as_list(found, comm_.rank()));
    rebuilds_since_cut_ = 0;
    best_imbalance_ = 0.0;
    ++cuts_;
}

/// The largest work over the mean, as recorded since the last cut. A limit that the last cut could not keep is
/// raised, or few large blocks would be cut again and again in vain.
template<int D> bool Domain<D>::unbalanced()
{
    std::int64_t mine = 0;
    for (const BlockWork& block : work_) mine += block.work;
    const auto mean = static_cast<double>(comm_.sum(mine)) / comm_.size();
    const auto largest = static_cast<double>(comm_.max(mine));
    if (mean == 0.0) return false;
    const double imbalance = largest / mean;
    if (best_imbalance_ == 0.0) best_imbalance_ = imbalance;
    return rebuilds_since_cut_ >= settings_.rebuilds_between &&
           imbalance > std::max(settings_.limit, 1.1 * best_imbalance_);
}

template<int D> void Domain<D>::migrate(Particles<D>& particles)
{
    std::vector<std::vector<char>> leaving(static_cast<std::size_t>(comm_.size()));
    std::vector<std::uint8_t> staying(particles.size(), 1);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const int owner = blocks_.owner(blocks_.grid().key_of(particles.position[i]));
        if (owner == comm_.rank()) continue;
        staying[i] = 0;
        pack_particle(particles, i, leaving[static_cast<std::size_t>(owner)]);
    }
    keep_particles(particles, staying);
    for (const std::vector<char>& message : base::exchange_bytes(comm_, leaving)) {
        unpack_particles(particles, message, true);
    }
    particles.own_all();
}

template<int D> void Domain<D>::exchange_halo(Particles<D>& particles)
{
    const auto sent = halo_for_ranks(particles);
    std::vector<std::vector<char>> messages(sent.size());
    for (std::size_t r = 0; r < sent.size(); ++r) {
        for (const int i : sent[r]) pack_particle(particles, static_cast<std::size_t>(i), messages[r]);
    }
    std::vector<int> received;
    for (const std::vector<char>& message : base::exchange_bytes(comm_, messages)) {
        received.push_back(unpack_particles(particles, message, false));
    }
    const std::vector<int> new_index = sort_canonically(particles, cells_);
    make_scatter(sent, received, new_index);
}

/// Which of my particles each rank needs: those within reach of a block of that rank. Blocks are at least as wide as
/// the reach, so only the blocks that touch the particle's own come into question.
template<int D> std::vector<std::vector<int>> Domain<D>::halo_for_ranks(const Particles<D>& particles) const
{
    struct ForeignBlock {
        CellKey key;
        int owner;
    };
    std::map<CellKey, std::vector<ForeignBlock>> foreign_around;
    const auto foreign = [&](CellKey block) -> const std::vector<ForeignBlock>& {
        const auto [entry, is_new] = foreign_around.try_emplace(block);
        if (is_new) {
            for_each_adjacent<D>(block, [&](CellKey other) {
                const int owner = blocks_.owner(other);
                if (owner != BlockMap<D>::unknown && owner != comm_.rank()) entry->second.push_back({other, owner});
            });
        }
        return entry->second;
    };
    std::vector<std::vector<int>> sent(static_cast<std::size_t>(comm_.size()));
    for (std::size_t i = 0; i < particles.size(); ++i) {
        for (const auto& [key, owner] : foreign(blocks_.grid().key_of(particles.position[i]))) {
            auto& list = sent[static_cast<std::size_t>(owner)];
            if (!list.empty() && list.back() == static_cast<int>(i)) continue;
            if (within_reach(particles.position[i], key)) list.push_back(static_cast<int>(i));
        }
    }
    return sent;
}

template<int D> bool Domain<D>::within_reach(const Vec<D>& x, CellKey block) const
{
    const double size = blocks_.grid().cell_size();
    const auto cell = CellGrid<D>::cell(block);
    double distance_squared = 0.0;
    for (int d = 0; d < D; ++d) {
        const double low = cell[static_cast<std::size_t>(d)] * size;
        const double outside = std::max({low - x[d], x[d] - (low + size), 0.0});
        distance_squared += outside * outside;
    }
    const double reach = cells_.cell_size() * (1.0 + 1e-9); // round-off in the block's edges must not lose anyone
    return distance_squared <= reach * reach;
}

template<int D>
void Domain<D>::make_scatter(const std::vector<std::vector<int>>& sent, const std::vector<int>& received,
                             const std::vector<int>& new_index)
{
    base::ScatterPlan plan;
    std::size_t next = new_index.size();
    for (const int count : received) next -= static_cast<std::size_t>(count);
    for (std::size_t r = 0; r < sent.size(); ++r) {
        const std::size_t last = next + static_cast<std::size_t>(received[r]);
        if (sent[r].empty() && received[r] == 0) continue;
        plan.neighbours.push_back(static_cast<int>(r));
        for (const int i : sent[r]) plan.send_indices.push_back(new_index[static_cast<std::size_t>(i)]);
        for (; next < last; ++next) plan.receive_indices.push_back(new_index[next]);
        plan.send_offsets.push_back(static_cast<int>(plan.send_indices.size()));
        plan.receive_offsets.push_back(static_cast<int>(plan.receive_indices.size()));
    }
    scatter_ = base::Scatter(comm_, std::move(plan));
}

template<int D> void Domain<D>::refresh_state(Particles<D>& particles) const
{
    scatter_.forward(particles.position, particles.volume, particles.mass, particles.momentum);
}

template<int D> void Domain<D>::refresh_gradients(Particles<D>& particles) const
{
    scatter_.forward(particles.density_gradient, particles.velocity_gradient);
}

template<int D> void Domain<D>::record_work(const Particles<D>& particles, std::span<const std::size_t> row_offsets)
{
    if (comm_.size() == 1) return;
    std::map<CellKey, std::int64_t> work;
    constexpr std::int64_t per_particle = 10; // what a particle costs beside its neighbours, in neighbours
    for (std::size_t k = 0; k < particles.owned.size(); ++k) {
        const Vec<D>& x = particles.position[static_cast<std::size_t>(particles.owned[k])];
        work[blocks_.grid().key_of(x)] += per_particle + static_cast<std::int64_t>(row_offsets[k + 1] - row_offsets[k]);
    }
    work_ = as_list(work, comm_.rank());
}

template class Domain<2>;
template class Domain<3>;

} // namespace sph

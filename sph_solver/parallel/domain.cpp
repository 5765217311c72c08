// SPDX-License-Identifier: MIT
#include "sph_solver/parallel/domain.hpp"

#include "coupler_lib/foundation/exchange.hpp"
#include "sph_solver/parallel/packing.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

std::vector<BlockWork> as_list(const std::map<CellKey, std::int64_t>& work, int rank)
{
    std::vector<BlockWork> list;
    for (const auto& [block, amount] : work) list.push_back({block, amount, rank});
    return list;
}

} // namespace

template<int D>
Domain<D>::Domain(const base::Communicator& comm, const CellGrid<D>& grid, const RebalanceSettings& settings)
    : comm_(comm), cells_(grid), blocks_(grid.cell_size()), balance_(settings)
{}

template<int D> void Domain<D>::redistribute(Particles<D>& particles)
{
    base::ensure(!state_travels_, "nothing is on its way when the plan changes");
    if (comm_.size() == 1) {
        sort_alone(particles);
    } else {
        drop_halo(particles);
        update_blocks(particles);
        migrate(particles);
        exchange_halo(particles);
    }
    least_owned_ = std::min(least_owned_, particles.owned.size());
}

template<int D> void Domain<D>::sort_alone(Particles<D>& particles) { sort_canonically(particles, cells_); }

/// Every block with particles has an owner afterwards: newly entered blocks are given away, and all are cut anew when
/// there was no cut yet or the work has become too uneven.
template<int D> void Domain<D>::update_blocks(const Particles<D>& particles)
{
    balance_.count_rebuild();
    std::map<CellKey, std::int64_t> counts;
    auto last = counts.end();
    for (const Vec<D>& x : particles.position) { // most particles are in the block of the one before
        const CellKey block = blocks_.grid().key_of(x);
        if (last == counts.end() || last->first != block) last = counts.try_emplace(block, 0).first;
        ++last->second;
    }
    const bool first = blocks_.empty();
    if (!first) {
        auto entered = counts;
        std::erase_if(entered,
                      [this](const auto& block) { return blocks_.owner(block.first) != BlockMap<D>::unknown; });
        blocks_.adopt(comm_, as_list(entered, comm_.rank()));
    }
    const bool overgrown = blocks_.size() > 2 * blocks_at_attempt_; // by blocks that water has left
    if (!first && !overgrown && !balance_.is_due()) return;
    balance_.tried(blocks_.repartition(comm_, with_recorded_work(counts), balance_.settings().gain));
    blocks_at_attempt_ = blocks_.size();
}

/// The work as recorded; as many particles as there are, at the mean cost, where a block has been entered since.
template<int D>
std::vector<BlockWork> Domain<D>::with_recorded_work(const std::map<CellKey, std::int64_t>& counts) const
{
    std::vector<BlockWork> work;
    for (const auto& [block, count] : counts) {
        const auto known = work_.find(block);
        work.push_back({block, known == work_.end() ? count * mean_work_ : known->second, comm_.rank()});
    }
    return work;
}

template<int D> void Domain<D>::migrate(Particles<D>& particles)
{
    std::vector<std::vector<char>> leaving(static_cast<std::size_t>(comm_.size()));
    std::vector<std::uint8_t> staying(particles.size(), 1);
    CellKey last = ~CellKey{0};
    int owner = comm_.rank();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const CellKey block = blocks_.grid().key_of(particles.position[i]);
        if (block != last) owner = blocks_.owner(last = block);
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
    CellKey last = ~CellKey{0};
    const std::vector<ForeignBlock>* around = nullptr;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const CellKey block = blocks_.grid().key_of(particles.position[i]);
        if (block != last) around = &foreign(last = block);
        for (const auto& [key, owner] : *around) {
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

template<int D> void Domain<D>::start_state(const Particles<D>& particles)
{
    scatter_.start(particles.position, particles.volume, particles.mass, particles.momentum);
    state_travels_ = true;
}

template<int D> void Domain<D>::finish_state(Particles<D>& particles)
{
    if (state_travels_) scatter_.finish(particles.position, particles.volume, particles.mass, particles.momentum);
    state_travels_ = false;
}

template<int D> void Domain<D>::start_gradients(const Particles<D>& particles) const
{
    scatter_.start(particles.density_gradient, particles.velocity_gradient, particles.renormaliser, particles.shift);
}

template<int D> void Domain<D>::finish_gradients(Particles<D>& particles) const
{
    scatter_.finish(particles.density_gradient, particles.velocity_gradient, particles.renormaliser, particles.shift);
}

template<int D>
void Domain<D>::record_work(const Particles<D>& particles, std::span<const double> costs, double measured)
{
    if (comm_.size() == 1) return;
    balance_.note(comm_, measured);
    constexpr double picoseconds = 1e12;
    std::int64_t all = 0;
    work_.clear();
    for (std::size_t k = 0; k < particles.owned.size(); ++k) {
        const Vec<D>& x = particles.position[static_cast<std::size_t>(particles.owned[k])];
        const std::int64_t work = 1 + std::llround(picoseconds * costs[k]);
        work_[blocks_.grid().key_of(x)] += work;
        all += work;
    }
    mean_work_ = comm_.sum(all) / std::max<std::int64_t>(1, comm_.sum(static_cast<std::int64_t>(costs.size())));
}

template class Domain<2>;
template class Domain<3>;

} // namespace sph

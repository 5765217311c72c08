// SPDX-License-Identifier: MIT
#include "sph_solver/operators/neighbours_in_reach.hpp"

#include <algorithm>

namespace sph {

template<int D>
const ReachedNeighbours& NeighboursInReach<D>::select(const Particles<D>& particles, const NeighbourList& neighbours)
{
    start(particles, neighbours);
    points_.load(particles.position);
    select(neighbours, RowSet(particles.owned));
    return reached_;
}

template<int D> void NeighboursInReach<D>::start(const Particles<D>& particles, const NeighbourList& neighbours)
{
    static_assert(selection_overhang <= row_unit);
    points_.resize(particles.size());
    const std::size_t rows = neighbours.rows();
    reached_.begins.resize(rows);
    reached_.splits.resize(rows);
    reached_.ends.resize(rows);
    // A row takes up to two units more than its candidates: the one behind it, and the one to fill up.
    const std::size_t room = neighbours.indices.size() + 2 * (rows + 2) * row_unit;
    if (reached_.indices.size() < room) reached_.indices.resize(room);
    reached_.longest = 0;
    next_ = 0;
}

template<int D> void NeighboursInReach<D>::take_positions(const Particles<D>& particles, const std::vector<int>& which)
{
    for (const int i : which) points_.set(i, particles.position[static_cast<std::size_t>(i)]);
}

template<int D> void NeighboursInReach<D>::select(const NeighbourList& neighbours, const RowSet& rows)
{
    int* const first = reached_.indices.data();
    int* out = first + next_;
    std::size_t longest = reached_.longest;
    rows.for_each([&](std::size_t k, int i) {
        const auto [end, before] = points_.select(i, limit_, neighbours.of(k), out);
        reached_.begins[k] = static_cast<std::size_t>(out - first);
        const auto length = static_cast<std::size_t>(end - out);
        std::fill_n(end, 2 * row_unit, i);
        reached_.splits[k] = reached_.begins[k] + static_cast<std::size_t>(before);
        reached_.ends[k] = static_cast<std::size_t>(end - first);
        longest = std::max(longest, whole_units(length));
        out += whole_units(length + row_unit - 1);
    });
    reached_.longest = longest;
    next_ = static_cast<std::size_t>(out - first);
}

template class NeighboursInReach<2>;
template class NeighboursInReach<3>;

} // namespace sph

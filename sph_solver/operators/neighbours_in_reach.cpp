// SPDX-License-Identifier: MIT
#include "sph_solver/operators/neighbours_in_reach.hpp"

#include <algorithm>
#include <bit>

namespace sph {

void ReachedNeighbours::start(const NeighbourList& list)
{
    static_assert(selection_overhang <= row_overhang);
    list_ = &list;
    std::size_t longest = 0;
    for (std::size_t k = 0; k < list.rows(); ++k) longest = std::max(longest, list.of(k).size());
    longest_ = whole_units(longest);
    bits_.resize(list.rows() + list.indices.size() / 8 + 2);
    row_.resize(longest_ + row_overhang);
}

/// A row of n entries has its bits in n / 8 + 1 bytes.
std::size_t ReachedNeighbours::count(std::size_t k) const
{
    const std::uint8_t* bits = &bits_[place(k)];
    int count = 0;
    for (std::size_t n = 0; n <= list_->of(k).size() / 8; ++n) count += std::popcount(bits[n]);
    return static_cast<std::size_t>(count);
}

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
    points_.resize(particles.size());
    reached_.start(neighbours);
}

template<int D> void NeighboursInReach<D>::take_positions(const Particles<D>& particles, const std::vector<int>& which)
{
    for (const int i : which) points_.set(i, particles.position[static_cast<std::size_t>(i)]);
}

template<int D> void NeighboursInReach<D>::select(const NeighbourList& neighbours, const RowSet& rows)
{
    rows.for_each([&](std::size_t k, int i) { points_.mark(i, limit_, neighbours.of(k), reached_.bits_of(k)); });
}

template class NeighboursInReach<2>;
template class NeighboursInReach<3>;

} // namespace sph

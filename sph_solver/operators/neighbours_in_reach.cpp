// SPDX-License-Identifier: MIT
#include "sph_solver/operators/neighbours_in_reach.hpp"

#include <algorithm>

namespace sph {

void ReachedNeighbours::start(const NeighbourList& list)
{
    static_assert(selection_overhang <= row_overhang);
    list_ = &list;
    longest_ = whole_units(list.longest());
    bits_.resize(list.rows() + list.words_before(list.rows()) / 8 + 4);
    row_.resize(longest_ + row_overhang);
}

std::size_t ReachedNeighbours::count(std::size_t k) const { return row(k, 0).size; }

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
    row_.resize(neighbours.longest() + row_overhang);
    rows.for_each([&](std::size_t k, int i) {
        int* const end = neighbours.copy(k, row_.data());
        std::fill_n(end, row_unit, i);
        points_.mark(i, limit_, {row_.data(), end}, reached_.bits_of(k));
    });
}

template class NeighboursInReach<2>;
template class NeighboursInReach<3>;

} // namespace sph

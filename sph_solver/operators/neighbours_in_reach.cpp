// SPDX-License-Identifier: MIT
#include "sph_solver/operators/neighbours_in_reach.hpp"

#include <algorithm>

namespace sph {

template<int D>
const ReachedNeighbours& NeighboursInReach<D>::select(const Particles<D>& particles, const NeighbourList& neighbours)
{
    static_assert(selection_overhang <= pack_size);
    points_.load(particles.position);
    const std::size_t rows = neighbours.rows();
    reached_.begins.resize(rows);
    reached_.ends.resize(rows);
    // A row takes up to a pack more than its candidates: the one to fill up, and the one written past the end.
    const std::size_t room = neighbours.indices.size() + (rows + 1) * pack_size;
    if (reached_.indices.size() < room) reached_.indices.resize(room);
    int* const first = reached_.indices.data();
    int* out = first;
    for (std::size_t k = 0; k < rows; ++k) {
        int* const end = points_.select(particles.owned[k], limit_, neighbours.of(k), out);
        reached_.begins[k] = static_cast<std::size_t>(out - first);
        reached_.ends[k] = static_cast<std::size_t>(end - first);
        std::fill_n(end, pack_size, particles.owned[k]);
        out += ReachedNeighbours::whole_packs(static_cast<std::size_t>(end - out));
    }
    return reached_;
}

template class NeighboursInReach<2>;
template class NeighboursInReach<3>;

} // namespace sph

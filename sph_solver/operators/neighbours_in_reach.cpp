// SPDX-License-Identifier: MIT
#include "sph_solver/operators/neighbours_in_reach.hpp"

namespace sph {

template<int D>
const NeighbourList& NeighboursInReach<D>::select(const Particles<D>& particles, const NeighbourList& neighbours)
{
    points_.load(particles.position);
    reached_.offsets.resize(neighbours.offsets.size());
    const std::size_t room = neighbours.indices.size() + selection_overhang;
    if (reached_.indices.size() < room) reached_.indices.resize(room);
    int* const first = reached_.indices.data();
    int* out = first;
    for (std::size_t k = 0; k < neighbours.rows(); ++k) {
        out = points_.select(particles.owned[k], limit_, neighbours.of(k), out);
        reached_.offsets[k + 1] = static_cast<std::size_t>(out - first);
    }
    return reached_;
}

template class NeighboursInReach<2>;
template class NeighboursInReach<3>;

} // namespace sph

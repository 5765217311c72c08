// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/neighbour_search.hpp"
#include "sph_solver/parallel/domain.hpp"
#include "tests/sph_solver/support/random_particles.hpp"

#include <numeric>

/// What the tests of the fluid on many ranks share.
namespace sph {

inline const base::Communicator& world()
{
    static const base::Communicator comm = base::Communicator::world();
    return comm;
}

/// Every `size`-th particle: an initial distribution that has nothing to do with space.
template<int D> Particles<D> share(Particles<D> all)
{
    std::vector<std::uint8_t> mine(all.size(), 0);
    for (std::size_t i = 0; i < all.size(); ++i)
        mine[i] = static_cast<int>(i) % world().size() == world().rank() ? 1 : 0;
    keep_particles(all, mine);
    return all;
}

/// As if a particle cost a nanosecond for each neighbour.
template<int D> void record_neighbours(Domain<D>& domain, const Particles<D>& particles, const NeighbourList& list)
{
    std::vector<double> costs;
    for (std::size_t k = 0; k < list.rows(); ++k) costs.push_back(1e-9 * static_cast<double>(list.of(k).size()));
    domain.record_work(particles, costs, std::accumulate(costs.begin(), costs.end(), 0.0));
}

} // namespace sph

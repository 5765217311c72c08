// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "tests/sph_solver/support/sample_fluid.hpp"

namespace sph::sample {

/// Every owned particle against every local one, in the form that the pair loops read.
template<int D> ReachedNeighbours reached_neighbours(const Particles<D>& particles, double support)
{
    NeighboursInReach<D> in_reach(support);
    return in_reach.select(particles, brute_force_neighbours(particles, 1.1 * support));
}

} // namespace sph::sample

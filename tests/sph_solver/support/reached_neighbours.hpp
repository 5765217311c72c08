// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "tests/sph_solver/support/sample_fluid.hpp"

#include <memory>

namespace sph::sample {

/// Spacing of the lattices in the tests of the operators [m].
inline constexpr double dx = 0.01;

/// Neighbours in reach with the list that they refer to.
struct HeldNeighbours : ReachedNeighbours {
    std::shared_ptr<const NeighbourList> list;
};

/// Every owned particle against every local one, in the form that the pair loops read.
template<int D> HeldNeighbours reached_neighbours(const Particles<D>& particles, double support)
{
    NeighboursInReach<D> in_reach(support);
    const auto list = std::make_shared<const NeighbourList>(brute_force_neighbours(particles, 1.1 * support));
    return {in_reach.select(particles, *list), list};
}

} // namespace sph::sample

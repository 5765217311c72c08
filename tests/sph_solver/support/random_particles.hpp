// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/state/particles.hpp"

#include <random>

namespace sph::testing {

/// The same random particles on every rank: an L of `count` particles in the unit square or cube, with two far away, so
/// that blocks differ in weight and the domain has holes. Global order by id; all owned.
template<int D> Particles<D> random_particles(int count, unsigned seed = 1)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    Particles<D> particles;
    particles.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < particles.size(); ++i) {
        particles.id[i] = static_cast<std::int64_t>(i);
        Vec<D>& x = particles.position[i];
        do {
            for (int d = 0; d < D; ++d) x[d] = uniform(generator);
        } while (x[0] > 0.4 && x[1] > 0.4);
        if (i < 2) x = Vec<D>::Constant(-3.0 + 5.0 * static_cast<double>(i));
        particles.volume[i] = 0.5 + uniform(generator);
        particles.mass[i] = 0.5 + uniform(generator);
        for (int d = 0; d < D; ++d) particles.momentum[i][d] = uniform(generator) - 0.5;
    }
    particles.own_all();
    return particles;
}

} // namespace sph::testing

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/neighbour_list.hpp"
#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/state/particles.hpp"
#include "tests/sph_solver/support/noise.hpp"

#include <cmath>

/// Small made-up fluids for tests and benchmarks.
namespace sph::sample {

/// Square or cube of `side` particles along each axis with spacing dx, moved by up to `jitter` dx, at rest with
/// density rho0.
template<int D> Particles<D> jittered_lattice(int side, double dx, double jitter, double rho0)
{
    Noise noise(7);
    Particles<D> particles;
    std::size_t count = 1;
    for (int a = 0; a < D; ++a) count *= static_cast<std::size_t>(side);
    particles.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t rest = i;
        particles.id[i] = static_cast<std::int64_t>(i);
        for (int a = 0; a < D; ++a) {
            particles.position[i][a] =
                (static_cast<double>(rest % static_cast<std::size_t>(side)) + 0.5 + jitter * noise()) * dx;
            rest /= static_cast<std::size_t>(side);
        }
        particles.volume[i] = std::pow(dx, D);
        particles.mass[i] = rho0 * particles.volume[i];
        particles.momentum[i].setZero();
    }
    particles.own_all();
    return particles;
}

/// Every owned particle against every local one.
template<int D> NeighbourList brute_force_neighbours(const Particles<D>& particles, double reach)
{
    NeighbourList list;
    for (const int i : particles.owned) {
        std::vector<int> row;
        for (int j = 0; j < static_cast<int>(particles.size()); ++j) {
            const Vec<D> x_ij =
                particles.position[static_cast<std::size_t>(j)] - particles.position[static_cast<std::size_t>(i)];
            if (j != i && x_ij.squaredNorm() < reach * reach) row.push_back(j);
        }
        list.append(row);
    }
    list.finish();
    return list;
}

} // namespace sph::sample

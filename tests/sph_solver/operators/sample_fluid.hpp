// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/neighbour_list.hpp"
#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/state/particles.hpp"

#include <cstdint>

/// Small made-up fluids for tests and benchmarks.
namespace sph::sample {

/// A repeatable stream of numbers in [-1, 1), the same on every machine.
class Noise {
public:
    explicit Noise(std::uint64_t seed) : state_(seed) {}

    double operator()()
    {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) * (2.0 / 9007199254740992.0) - 1.0;
    }

private:
    std::uint64_t state_;
};

/// Square or cube of `side` particles along each axis with spacing dx, moved by up to `jitter` dx, at rest with density rho0.
template <int D>
Particles<D> jittered_lattice(int side, double dx, double jitter, double rho0)
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
            particles.position[i][a] = (static_cast<double>(rest % static_cast<std::size_t>(side)) + 0.5 + jitter * noise()) * dx;
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
template <int D>
NeighbourList brute_force_neighbours(const Particles<D>& particles, double reach)
{
    NeighbourList list;
    for (const int i : particles.owned) {
        for (int j = 0; j < static_cast<int>(particles.size()); ++j) {
            const Vec<D> x_ij = particles.position[static_cast<std::size_t>(j)] - particles.position[static_cast<std::size_t>(i)];
            if (j != i && x_ij.squaredNorm() < reach * reach) list.indices.push_back(j);
        }
        list.offsets.push_back(list.indices.size());
    }
    return list;
}

} // namespace sph::sample

// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/coupling/surface.hpp"
#include "sph_solver/interface/interface_geometry.hpp"
#include "sph_solver/interface/interface_loads.hpp"
#include "tests/sph_solver/support/reached_neighbours.hpp"
#include "tests/sph_solver/support/wall_pass.hpp"

#include <gtest/gtest.h>

/// A plate of small facets below a lattice of water at rest, for tests of the interface. The unit of length is dx.
namespace sph::sample {

constexpr double gravity = 9.81;

template<int D> WallSettings<D> plate_settings()
{
    WallSettings<D> settings;
    settings.spacing = 1;
    settings.support = 2.46;
    settings.gravity[D - 1] = -gravity;
    return settings;
}

/// Facets at height zero over [0, size]^(D-1), `count` along each axis, facing up; nodes in rows.
template<int D> coupler::FacetBatch plate(double size, int count)
{
    coupler::FacetBatch batch;
    batch.dimension = D;
    const int rows = D == 2 ? 1 : count + 1;
    for (int r = 0; r < rows; ++r)
        for (int k = 0; k <= count; ++k) {
            batch.node_ids.push_back(100 + static_cast<std::int64_t>(batch.node_ids.size()));
            batch.motion.position.push_back(size * k / count);
            if (D == 3) batch.motion.position.push_back(size * r / count);
            batch.motion.position.push_back(0);
        }
    for (int r = 0; r < (D == 2 ? 1 : count); ++r)
        for (int k = 0; k < count; ++k) {
            const int node = r * (count + 1) + k;
            if (D == 2) batch.facet_nodes.push_back({node + 1, node, -1, -1});
            if (D == 3) batch.facet_nodes.push_back({node, node + 1, node + count + 2, node + count + 1});
            batch.facet_ids.push_back(7 + static_cast<std::int64_t>(batch.facet_ids.size()));
        }
    batch.motion.velocity.assign(batch.motion.position.size(), 0.0);
    batch.motion.acceleration.assign(batch.motion.position.size(), 0.0);
    return batch;
}

/// Water at rest with the hydrostatic pressure p = rho0 g (depth - height), particles at half spacings over the plate.
template<int D> Particles<D> water(int side, double depth, const Tait& eos)
{
    auto particles = jittered_lattice<D>(side, 1.0, 0.0, eos.rho0);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double height = particles.position[i][D - 1];
        particles.pressure[i] = eos.rho0 * gravity * (depth - height);
        particles.density[i] = eos.density(particles.pressure[i]);
        particles.sound_speed[i] = eos.sound_speed(particles.density[i]);
        particles.velocity[i].setZero();
        particles.density_gradient[i].setZero();
        particles.velocity_gradient[i].setZero();
    }
    return particles;
}

/// Water over the plate, evaluated once.
template<int D> struct WetPlate {
    int side = 10;
    double depth = 10;
    FluidModel<D> model{CubicSpline<D>(1.23), Tait{1000, 300}, VanAlbada{}, plate_settings<D>().gravity};
    coupler::FacetBatch batch;
    Walls<D> walls{plate_settings<D>()};
    Particles<D> particles;
    WallForces<D> forces;

    explicit WetPlate(int facets) : batch(plate<D>(side, facets)), particles(water<D>(side, depth, model.eos)) {}

    void evaluate()
    {
        set_interface_motion(walls, batch);
        walls.move(0);
        const auto neighbours = reached_neighbours(particles, 2.46);
        walls.prepare(particles, 0.1);
        walls.find_contacts(particles);
        Rates<D> rates;
        rates.reset(particles.size());
        forces = WallPass<D>(walls, particles, neighbours, model).forces(rates);
    }
};

} // namespace sph::sample

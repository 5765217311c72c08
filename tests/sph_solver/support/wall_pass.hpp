// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/operators/wall_flux.hpp"
#include "sph_solver/operators/wall_gradients.hpp"

/// The wall's part of an evaluation for tests that have particles, walls and neighbours at hand.
namespace sph::sample {

/// \pre walls.find_contacts(particles); all fields of the particles are set.
template<int D> struct WallPass {
    const Walls<D>& walls;
    const FluidModel<D>& model;
    PairRecords<D> records;
    WallImages<D> images;

    WallPass(const Walls<D>& walls_now, const Particles<D>& particles, const ReachedNeighbours& neighbours,
             const FluidModel<D>& fluid)
        : walls(walls_now), model(fluid)
    {
        records.load_states(particles, model.eos, particles.owned);
        records.load_slopes(particles, model, particles.owned);
        images.find(walls, records, particles, neighbours);
    }

    void add_gradients(GradientField<D>& sums) const { accumulate_wall_gradients(sums, images, walls, records, model); }

    WallForces<D> forces(Rates<D>& rates) const
    {
        WallForces<D> result;
        find_wall_forces(result, images, walls, records, model);
        add_wall_forces(rates, result, walls);
        return result;
    }
};

} // namespace sph::sample

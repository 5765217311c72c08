// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/operators/flux_sums.hpp"
#include "sph_solver/operators/wall_flux.hpp"
#include "sph_solver/state/particles.hpp"
#include "sph_solver/walls/walls.hpp"

namespace sph {

/// All that one evaluation of the rates leaves behind.
template<int D> struct Evaluation {
    Rates<D> rates;
    FluxField<D> fluxes;         ///< fluid pairs
    std::vector<Vec<D>> viscous; ///< force of the further terms on each owned particle [N]; empty: none
    WallForces<D> wall_forces;   ///< particles near walls, and their walls
};

/// Somebody who keeps account of what happens within a step: the energy ledger, the loads on the solid.
template<int D> class StageObserver {
public:
    virtual ~StageObserver() = default;

    /// Called once in every step before its first evaluation, with the walls and the neighbours of the step in place.
    virtual void begin_step(const Particles<D>&, const Walls<D>&, double /* dt */) {}

    /// Called after every evaluation whose rates count. \param weight the Runge-Kutta weight b_s of these rates;
    /// those of a step add up to 1, so an integral over the step takes weight * dt.
    virtual void observe(const Particles<D>& particles, const Walls<D>& walls, const Evaluation<D>& evaluation,
                         double weight, double dt) = 0;
};

} // namespace sph

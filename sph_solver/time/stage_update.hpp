// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/state/particles.hpp"
#include "sph_solver/time/runge_kutta.hpp"

#include <vector>

namespace sph {

/// Takes the conserved fields of the owned particles through the stages of a step. Position, volume, mass and
/// momentum are one vector y with the rates (v, dw/dt, dm/dt, dP/dt); all get the same weights.
template<int D> class StageUpdate {
public:
    /// Notes y_n.
    void start(const Particles<D>& particles);

    /// Adds the stage's rates to the step and puts the particles where the next stage, or the next step, begins.
    void apply(Particles<D>& particles, const Stage& stage, const Rates<D>& rates, double dt);

private:
    struct Conserved {
        Vec<D> position, momentum;
        double volume, mass;
    };
    inline static const Conserved no_change{Vec<D>::Zero(), Vec<D>::Zero(), 0.0, 0.0};

    std::vector<Conserved> start_; ///< y_n
    /// dt sum b_s k_s so far; empty before the first stage that counts and is not the last.
    std::vector<Conserved> change_;
};

} // namespace sph

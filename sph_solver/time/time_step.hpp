// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/state/particles.hpp"

namespace sph {

/// What the step size follows from.
struct TimeStepSettings {
    double cfl = 0.6;              ///< dt = cfl h / max(c) [-]
    double smoothing_length = 0.0; ///< h [m]
    double sound_speed = 0.0;      ///< c0 [m/s], the foot of the ladder
    double fixed_dt = 0.0;         ///< [s]; 0: follow the sound speed
    double viscosity = 0.0;        ///< kinematic, nu [m^2/s]
    int steps_of_one_length = 1;   ///< a step is chosen anew after so many
};

/// Chooses dt on a ladder of steps, so that it stays the same for long and the solid may keep its factorised matrix:
///
///     dt = (cfl h / c0) 2^(k/8),   k whole, next to cfl h / max(c)
///
/// The present rung is kept as long as cfl h / max(c) is within 3/4 of a rung from it: the Courant number stays
/// within 7 % of cfl. A viscous liquid bounds the step further, dt <= h^2 / (8 nu).
class TimeStep {
public:
    /// Throws Error(bad_input) when a size is not positive.
    explicit TimeStep(const TimeStepSettings& settings);

    /// The next step [s], the same on every rank. Collective. \pre sound_speed of the owned particles is up to date.
    template<int D> double next(const Particles<D>& particles, const base::Communicator& comm);

    /// Goes on from a restart file: the rung that was in use.
    int rung() const { return rung_; }
    void set_rung(int rung) { rung_ = rung; }

private:
    template<int D> double choose(const Particles<D>& particles, const base::Communicator& comm);
    double on_ladder(double largest_sound_speed);

    TimeStepSettings settings_;
    int rung_ = 0;
    double dt_ = 0.0;
    int used_ = 0; ///< of the steps of one length
};

} // namespace sph

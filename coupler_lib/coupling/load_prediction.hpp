// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/surface.hpp"

#include <memory>
#include <vector>

namespace coupler {

/// What a solid makes of a load before it steps with it. Load n is the fluid's mean over [t_n-1, t_n], so it belongs to the
/// middle of that step, and the solid applies it at the end of [t_n, t_n+1]: late by dt_n + dt_n-1/2. (Load 0 is that of
/// t_0.)
class LoadPrediction {
public:
    virtual ~LoadPrediction() = default;

    /// Once for each step, in order. \param velocity of the load's nodes at the start of the step [m/s], as the load's
    /// arrays are. \param dt of the step [s].
    virtual void apply(SurfaceLoad& load, const std::vector<double>& velocity, double dt) = 0;
};

/// Takes the load as it came: the paper's scheme.
std::unique_ptr<LoadPrediction> make_lagged_load();

/// Carries the load on to the end of the step, linearly in time through the last two, with c_n the middle that load n belongs
/// to; of second order where the load is smooth:
///
///     f* = f_n + (f_n - f_n-1) (t_n+1 - c_n) / (c_n - c_n-1)
std::unique_ptr<LoadPrediction> make_extrapolated_load();

/// For the impedance correction f(v) = f_n - Z (v - vbar), vbar the wall's velocity while load n was measured: the change of
/// velocity since then that a smooth motion explains is part of what the fluid already answers to. It is added to vbar,
///
///     vbar + (dt_n + dt_n-1/2) a_smooth,      a_smooth += ((v_n - v_n-1)/dt_n-1 - a_smooth)/steps
///
/// so that the correction acts on what is news only; without it the correction weighs on the wall like added mass.
/// \param steps over which the acceleration is averaged, positive.
std::unique_ptr<LoadPrediction> make_smoothed_reference(int steps);

} // namespace coupler

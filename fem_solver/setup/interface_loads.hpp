// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/impedance_load.hpp"
#include "fem_solver/assembly/pressure_load.hpp"
#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/interface/wet_boundary.hpp"

namespace fem {

/// How the fluid's load acts on the solid.
struct InterfaceLoadSettings {
    bool averaged = false;       ///< pressure on the current facets instead of nodal forces
    double impedance_factor = 0; ///< share of rho c answered within the step; 0: none
    int smoothing_steps = 0;     ///< steps over which the wall's known acceleration is averaged; 0: not taken off
};

/// Turns what the fluid sends into loads of the solid.
///
/// Impedance: the load was measured while the wall moved with the mean velocity vbar of the fluid's last step, half of
/// it, dt_(n-1)/2, before t_n; it acts at t_n+1. The velocity change between the two that a smooth motion explains,
/// (dt_n + dt_(n-1)/2) a_smooth, is part of what the fluid already answers to; only the rest is news:
///
///     f(v_1) = f_n - Z (v_1 - vbar_n - (dt_n + dt_(n-1)/2) a_smooth)
///
/// a_smooth follows the mean acceleration of each step with a lag of about `smoothing_steps` steps.
class InterfaceLoads {
public:
    /// Adds its loads to `forces`, which keeps them.
    InterfaceLoads(const Mesh& mesh, const WetBoundary& boundary, SolidForces& forces,
                   const InterfaceLoadSettings& settings);

    /// Sets the load of packet 0, to which the initial acceleration belongs.
    void start(const coupler::SurfaceLoad& load, const Motion& motion);
    /// Sets the load of the step that starts now. \param motion at its start. \param dt its length [s].
    void set(const coupler::SurfaceLoad& load, const Motion& motion, double dt);

private:
    void set_measured(const coupler::SurfaceLoad& load);
    void follow(const Motion& motion);
    std::vector<char> wet_facets(const coupler::SurfaceLoad& load) const;

    const WetBoundary* boundary_;
    InterfaceLoadSettings settings_;
    FacetPressure* pressure_ = nullptr; // owned by the forces
    DeadLoad* nodal_ = nullptr;
    ImpedanceLoad* impedance_ = nullptr;
    Eigen::VectorXd last_velocity_, smooth_acceleration_;
    double last_dt_ = 0;
};

} // namespace fem

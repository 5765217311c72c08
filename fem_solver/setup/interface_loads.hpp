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
};

/// Turns what the fluid sends into loads of the solid.
///
/// Impedance: the load was measured while the wall moved with the velocity vbar; what the solid's step changes of that is
/// answered within the step, f(v_1) = f_n - Z (v_1 - vbar). Which part of the change is news is LoadPrediction's matter: it
/// has its say in vbar.
class InterfaceLoads {
public:
    /// Adds its loads to `forces`, which keeps them.
    InterfaceLoads(const Mesh& mesh, const WetBoundary& boundary, SolidForces& forces,
                   const InterfaceLoadSettings& settings);

    /// Sets the load of packet 0, to which the initial acceleration belongs.
    void start(const coupler::SurfaceLoad& load);
    /// Sets the load of the step that starts now. \param motion at its start.
    void set(const coupler::SurfaceLoad& load, const Motion& motion);

private:
    void set_measured(const coupler::SurfaceLoad& load);
    std::vector<char> wet_facets(const coupler::SurfaceLoad& load) const;

    const WetBoundary* boundary_;
    InterfaceLoadSettings settings_;
    FacetPressure* pressure_ = nullptr; // owned by the forces
    DeadLoad* nodal_ = nullptr;
    ImpedanceLoad* impedance_ = nullptr;
};

} // namespace fem

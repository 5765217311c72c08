// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace fem {

/// Energies now, and works and dissipations since the start [J] (2D: J/m). Work is positive when done on the solid.
struct SolidEnergies {
    double kinetic = 0, strain = 0, potential = 0;
    double work_interface = 0;  ///< by the fluid, the impedance correction included
    double work_correction = 0; ///< the correction's part of it
    double work_supports = 0, work_loads = 0;
    std::vector<double> work_of_load;    ///< parts of work_loads, one for each load
    std::vector<double> work_of_support; ///< parts of work_supports, one for each supported group
    double contact = 0;                  ///< work of the contact's pressure
    double friction = 0;                 ///< taken by friction: dissipated where the ground rests
    double damping = 0;                  ///< dissipated by C v
    double material = 0;                 ///< dissipated in the material
    double numerical_dissipation = 0;    ///< of the time scheme; second order in dt and not of one sign
    double balance_error = 0;            ///< what is left of the energy identity, see EnergyLedger

    double total() const { return kinetic + strain + potential; }
};

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/csv.hpp"

#include <array>
#include <string>

namespace sph {

/// One row of energy.csv: the whole fluid at one instant, works and dissipations cumulated since the start.
/// Energies [J], in 2D per metre of depth [J/m]. Work is positive when done on the fluid, dissipation when energy is lost.
struct EnergyRow {
    double time = 0; ///< [s]
    double dt = 0;   ///< of the step that led here [s]
    double kinetic = 0;
    double potential = 0;
    double internal = 0;
    double mass = 0;                          ///< of the water that is left [kg], [kg/m]
    double work_by_walls = 0;                 ///< of walls that the configuration moves
    double work_by_interface = 0;             ///< of the coupled solid's surface
    double outflow_mass = 0;                  ///< [kg], [kg/m]
    std::array<double, 3> outflow_momentum{}; ///< [kg m/s], [kg/s]
    double outflow_energy = 0;
    double dissipation_riemann = 0;
    double dissipation_mass_flux = 0;
    double dissipation_walls = 0;
    double viscous = 0;
    double balance_error = 0;                     ///< what none of the columns explains
    std::array<double, 3> momentum{};             ///< of the water that is left [kg m/s], [kg/s]
    std::array<double, 3> impulse_of_walls{};     ///< on the water [kg m/s], [kg/s]
    std::array<double, 3> impulse_of_interface{}; ///< likewise
    double trapped_particles = 0;                 ///< of the outflow, what was taken out between closing walls
    double trapped_mass = 0;                      ///< [kg], [kg/m]
    double trapped_energy = 0;

    [[nodiscard]] double total() const { return kinetic + potential + internal; }
};

/// Writes energy.csv; made on one rank only.
class EnergyTable {
public:
    EnergyTable(const std::string& folder, int dimension);
    void write(const EnergyRow& row);
    void flush() { file_.flush(); }

private:
    base::CsvWriter file_;
};

} // namespace sph

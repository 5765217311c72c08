// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/csv.hpp"
#include "fem_solver/dofs/solid_energies.hpp"

namespace fem {

/// energy.csv: energies, works and dissipations over time [J] (2D: J/m). No contact is computed, so its two columns
/// are zero. Each load's own work has a column at the end, "work_load.NAME", and so has that of each supported group,
/// "work_support.GROUP".
class EnergyTable {
public:
    EnergyTable(const std::string& folder, int dimension, const std::vector<std::string>& loads,
                const std::vector<std::string>& supports);

    /// \param time [s]. \param dt length of the step that ended there [s].
    void write(double time, double dt, const SolidEnergies& energies);

private:
    std::size_t loads_, supports_;
    base::CsvWriter file_;
};

} // namespace fem

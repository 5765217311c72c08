// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/csv.hpp"
#include "coupler_lib/coupling/surface.hpp"

#include <string>
#include <vector>

namespace coupler {

/// DIR/energy_total.csv: the fluid and all its solids together, with the drift
///
///     (E_f + sum E_s + E_outflow - W_external)(t)   minus the same at the start.
///
/// Written by one rank, from the reports that travel with the packets.
class EnergyRecord {
public:
    EnergyRecord(const std::string& output_dir, int dimension);

    /// Takes in the reports of one instant [s].
    void add(double time, const FluidEnergies& fluid, const std::vector<SolidReport>& solids);
    /// A row for what was added last.
    void write();
    /// Of the last that was added [J].
    double drift() const { return drift_; }

private:
    base::CsvWriter table_;
    std::vector<double> row_;
    bool started_ = false;
    double start_ = 0, drift_ = 0;
};

} // namespace coupler

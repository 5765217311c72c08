// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/csv.hpp"
#include "coupler_lib/coupling/audit.hpp"
#include "coupler_lib/coupling/surface.hpp"

#include <string>
#include <vector>

namespace coupler {

/// The tables that need both sides: DIR/coupling/interface.csv (motion, force, moment, work of both sides, waits) and
/// DIR/energy_total.csv (fluid + solid, with the drift (E_f + E_s - W_external)(t) minus the same at the start).
/// Written by one rank, from the reports that travel with the packets.
class InterfaceRecord {
public:
    InterfaceRecord(const std::string& output_dir, int dimension);

    /// Adds the exchange at `window.time` to the audit.
    void add(const Window& window, const FluidReport& fluid, const SolidReport& solid);
    /// One row in each table for the last exchange added.
    void write();

    const InterfaceAudit& audit() const { return audit_; }
    /// Drift of the total energy at the last exchange [J].
    double energy_drift() const { return drift_; }

private:
    InterfaceAudit audit_;
    base::CsvWriter interface_, energy_;
    std::vector<double> energies_;
    bool started_ = false;
    double balance_start_ = 0, drift_ = 0;
};

}  // namespace coupler

// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/csv.hpp"
#include "coupler_lib/coupling/audit.hpp"
#include "coupler_lib/coupling/surface.hpp"

#include <string>

namespace coupler {

/// The table of one interface, which needs both sides: motion, force, moment, work of both, waits. Written by one rank,
/// from the reports that travel with the packets.
class InterfaceRecord {
public:
    InterfaceRecord(const std::string& path, int dimension) : audit_(dimension), table_(path, audit_.columns()) {}

    /// Adds the exchange at `window.time` to the audit.
    void add(const Window& window, const FluidReport& fluid, const SolidReport& solid)
    {
        audit_.record(window, fluid, solid);
    }
    /// A row for the last exchange added.
    void write()
    {
        table_.row(audit_.row());
        table_.flush();
    }
    const InterfaceAudit& audit() const { return audit_; }

private:
    InterfaceAudit audit_;
    base::CsvWriter table_;
};

/// DIR/coupling/interface.csv, or DIR/coupling/interface.SOLID.csv where the run has several interfaces.
inline std::string interface_path(const std::string& output_dir, const std::string& solid, bool only_one)
{
    return output_dir + "/coupling/interface" + (only_one ? "" : "." + solid) + ".csv";
}

} // namespace coupler

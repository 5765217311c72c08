// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/csv.hpp"
#include "coupler_lib/base/output_clock.hpp"
#include "coupler_lib/session/session.hpp"
#include "sph_solver/config/fluid_config.hpp"
#include "sph_solver/output/energy_table.hpp"
#include "sph_solver/output/field_output.hpp"
#include "sph_solver/output/probes.hpp"
#include "sph_solver/time/energy_ledger.hpp"

#include <optional>

namespace sph {

/// Where a run is: `step` steps done, the last one `dt` long, at `time`.
struct Instant {
    std::int64_t step = 0;
    double time = 0; ///< [s]
    double dt = 0;   ///< [s]
    bool last = false;
};

/// What a run writes of the fluid, and when: rows of energy.csv and probes.csv, all particles, figures of the whole run.
template<int D> class FluidOutput {
public:
    FluidOutput(const FluidConfig& config, coupler::Session& session, const FluidModel<D>& model);

    /// Asks the clocks for this instant; to be called once for each.
    void look_at(const Instant& now);
    [[nodiscard]] bool row_due() const { return row_due_; }
    [[nodiscard]] bool fields_due() const { return fields_due_; }

    /// Writes a row of energy.csv and one of probes.csv. Collective.
    void write_row(const Instant& now, const EnergyBalance& energies, const Particles<D>& particles);

    /// Writes all particles, and notes how deep any sits in a wall. Collective; \pre walls.find_contacts(particles)
    void write_fields(const Instant& now, const Particles<D>& particles, const Walls<D>& walls);

    /// Adds what was noted to the figures of the run.
    void summarise(base::JsonObject& figures) const;

private:
    coupler::Session& session_;
    Probes<D> probes_;
    base::OutputClock row_clock_, field_clock_;
    bool row_due_ = false, fields_due_ = false;
    FieldOutput<D> fields_;
    std::optional<EnergyTable> energy_table_;    ///< on rank 0
    std::optional<base::CsvWriter> probe_table_; ///< on rank 0
    double start_mass_ = -1.0;
    double largest_mass_error_ = 0.0;
    Penetration worst_;
};

} // namespace sph

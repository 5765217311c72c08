// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/output_clock.hpp"
#include "coupler_lib/session/session.hpp"
#include "fem_solver/output/contact_table.hpp"
#include "fem_solver/output/energy_table.hpp"
#include "fem_solver/output/field_file.hpp"
#include "fem_solver/output/probes.hpp"
#include "fem_solver/setup/solid_model.hpp"

namespace fem {

/// Where the run is: time [s], number and length [s] of the step that ended there.
struct Instant {
    double time = 0;
    long step = 0;
    double dt = 0;
    bool last = false;
};

/// All files that the solid writes over time, each when it is due: energy.csv, probes.csv, reactions.csv,
/// contact.csv, fields.
///
/// Collective over the solid's ranks.
class SolidOutput {
public:
    SolidOutput(const SolidConfig& config, coupler::Session& session, const SolidModel& model);

    /// \param reaction, load forces of the supports and of the fluid, one entry per degree of freedom [N].
    void write(const Instant& now, const Motion& motion, const SolidEnergies& energies, const Eigen::VectorXd& reaction,
               const Eigen::VectorXd& load);

private:
    void open_tables(const std::string& folder);
    void write_rows(const Instant& now, const Motion& motion, const SolidEnergies& energies,
                    const Eigen::VectorXd& reaction, const Eigen::VectorXd& load);
    ContactFields contact_fields(const Instant& now, const Motion& motion) const;
    std::vector<double> reactions(double time, const Motion& motion, const Eigen::VectorXd& reaction) const;

    const SolidModel& model_;
    Probes probes_;
    base::OutputClock row_clock_, field_clock_;
    std::optional<EnergyTable> energy_table_; // tables are rank 0's
    std::optional<base::CsvWriter> probe_table_, reaction_table_;
    std::optional<ContactTable> contact_table_;
    FieldFile fields_;
};

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/solid_output.hpp"

namespace fem {
namespace {

using Zero = base::OutputClock::Zero;

std::vector<std::string> with_time(const std::vector<std::string>& columns)
{
    std::vector<std::string> header{"t[s]"};
    header.insert(header.end(), columns.begin(), columns.end());
    return header;
}

std::vector<std::string> reaction_columns(const SolidModel& model)
{
    std::vector<std::string> columns;
    const int d = model.mesh().dimension;
    for (const std::string& group : model.supports().groups())
        for (int k = 0; k < d; ++k) columns.push_back(group + ".f" + "xyz"[k] + (d == 2 ? "[N/m]" : "[N]"));
    for (const auto& driven : model.supports().driven())
        for (int k = d == 2 ? 2 : 0; k < 3; ++k)
            columns.push_back(driven.group + ".m" + "xyz"[k] + (d == 2 ? "[N m/m]" : "[N m]"));
    return columns;
}

double table_interval(const SolidConfig& config, const coupler::Session& session)
{
    return session.coupled() ? session.coupling().output.table_interval : config.output.table_interval;
}

double field_interval(const SolidConfig& config, const coupler::Session& session)
{
    return session.coupled() ? session.coupling().output.interval : config.output.interval;
}

} // namespace

SolidOutput::SolidOutput(const SolidConfig& config, coupler::Session& session, const SolidModel& model)
    : model_(model),
      probes_(model.mesh(), config.probes),
      row_clock_(table_interval(config, session), Zero::every_step),
      field_clock_(field_interval(config, session), Zero::never),
      fields_(session.own_dir(), model.mesh(), model.forces().map(), session.comm())
{
    if (session.is_root()) open_tables(session.own_dir());
}

void SolidOutput::open_tables(const std::string& folder)
{
    const int dimension = model_.mesh().dimension;
    energy_table_.emplace(folder, dimension, model_.forces().load_names(), model_.supports().groups());
    probe_table_.emplace(folder + "/probes.csv", with_time(probes_.columns()));
    reaction_table_.emplace(folder + "/reactions.csv", with_time(reaction_columns(model_)));
    if (!model_.contacts()) return;
    std::vector<std::string> groups;
    for (const auto& contact : model_.contacts()->all()) groups.push_back(contact->group());
    contact_table_.emplace(folder, dimension, groups);
}

void SolidOutput::write(const Instant& now, const Motion& motion, const SolidEnergies& energies,
                        const Eigen::VectorXd& reaction, const Eigen::VectorXd& load)
{
    if (row_clock_.due(now.time) || now.last) write_rows(now, motion, energies, reaction, load);
    if (field_clock_.due(now.time) || now.last)
        fields_.write(now.time, motion, model_.forces().body().stress(motion.displacement),
                      contact_fields(now, motion));
}

void SolidOutput::write_rows(const Instant& now, const Motion& motion, const SolidEnergies& energies,
                             const Eigen::VectorXd& reaction, const Eigen::VectorXd& load)
{
    const auto add_row = [&](std::optional<base::CsvWriter>& table, std::vector<double> row) {
        if (!table) return;
        row.insert(row.begin(), now.time);
        table->row(row);
        table->flush();
    };
    if (energy_table_) energy_table_->write(now.time, now.dt, energies);
    add_row(probe_table_, probes_.values(motion, load));
    add_row(reaction_table_, reactions(now.time, motion, reaction));
    if (!model_.contacts()) return;
    std::vector<ContactResultants> rows;
    for (const auto& contact : model_.contacts()->all()) rows.push_back(contact->resultants(motion, now.time));
    if (contact_table_) contact_table_->write(now.time, rows);
}

ContactFields SolidOutput::contact_fields(const Instant& now, const Motion& motion) const
{
    ContactFields fields;
    if (!model_.contacts()) return fields;
    const auto count = static_cast<std::size_t>(model_.mesh().nodes());
    fields.pressure.assign(count, 0.0);
    fields.slip.assign(count, 0.0);
    for (const auto& contact : model_.contacts()->all())
        contact->add_fields(motion, now.time, fields.pressure, fields.slip);
    fields.pressure.resize(static_cast<std::size_t>(model_.mesh().own_nodes()));
    fields.slip.resize(fields.pressure.size());
    return fields;
}

std::vector<double> SolidOutput::reactions(double time, const Motion& motion, const Eigen::VectorXd& reaction) const
{
    std::vector<double> sums;
    for (const std::string& group : model_.supports().groups())
        for (const double sum : model_.supports().reaction(group, reaction)) sums.push_back(sum);
    for (const auto& driven : model_.supports().driven()) {
        const Eigen::Vector3d moment = model_.supports().moment(driven, time, motion, reaction);
        sums.insert(sums.end(), moment.data() + (model_.mesh().dimension == 2 ? 2 : 0), moment.data() + 3);
    }
    return sums;
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "sph_solver/fluid_output.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

using Zero = base::OutputClock::Zero;

double field_interval(const FluidConfig& config, const coupler::Session& session)
{
    return session.coupled() ? session.coupling().output.interval : config.output.interval;
}

double table_interval(const FluidConfig& config, const coupler::Session& session)
{
    return session.coupled() ? session.coupling().output.table_interval : config.output.table_interval;
}

EnergyRow row_of(const Instant& now, const EnergyBalance& e)
{
    EnergyRow row;
    row.time = now.time;
    row.dt = now.dt;
    row.kinetic = e.kinetic;
    row.potential = e.potential;
    row.internal = e.internal;
    row.mass = e.mass;
    row.work_by_walls = e.work_by_walls;
    row.work_by_interface = e.work_by_interface;
    row.outflow_mass = e.outflow_mass;
    row.outflow_momentum = e.outflow_momentum;
    row.outflow_energy = e.outflow_energy;
    row.dissipation_riemann = e.dissipation_riemann;
    row.dissipation_mass_flux = e.dissipation_mass_flux;
    row.dissipation_walls = e.dissipation_walls;
    row.viscous = e.viscous;
    row.balance_error = e.balance_error;
    row.momentum = e.momentum;
    row.impulse_of_walls = e.impulse_of_walls;
    row.impulse_of_interface = e.impulse_of_interface;
    row.trapped_particles = e.trapped_particles;
    row.trapped_mass = e.trapped_mass;
    row.trapped_energy = e.trapped_energy;
    return row;
}

} // namespace

template<int D>
FluidOutput<D>::FluidOutput(const FluidConfig& config, coupler::Session& session, const FluidModel<D>& model)
    : session_(session),
      probes_(config.probes, model.kernel, config.resolution.spacing),
      row_clock_(table_interval(config, session), Zero::every_step),
      field_clock_(field_interval(config, session), Zero::never),
      fields_(session.own_dir(), session.comm())
{
    if (!session.is_root()) return;
    energy_table_.emplace(session.own_dir(), D);
    std::vector<std::string> columns = {"t[s]"};
    for (const std::string& column : probes_.columns()) columns.push_back(column);
    probe_table_.emplace(session.own_dir() + "/probes.csv", columns);
}

template<int D> void FluidOutput<D>::look_at(const Instant& now)
{
    row_due_ = row_clock_.due(now.time) || now.last;
    fields_due_ = field_clock_.due(now.time) || now.last;
}

template<int D>
void FluidOutput<D>::write_row(const Instant& now, const EnergyBalance& energies, const Particles<D>& particles)
{
    const double mass = energies.mass + energies.outflow_mass;
    if (start_mass_ < 0.0) start_mass_ = mass;
    largest_mass_error_ = std::max(largest_mass_error_, std::abs(mass / start_mass_ - 1.0));
    std::vector<double> values = {now.time};
    for (const double value : probes_.values(particles, session_.comm())) values.push_back(value);
    if (!energy_table_) return;
    energy_table_->write(row_of(now, energies));
    energy_table_->flush();
    probe_table_->row(values);
    probe_table_->flush();
}

template<int D>
void FluidOutput<D>::write_fields(const Instant& now, const Particles<D>& particles, const Walls<D>& walls)
{
    fields_.write(now.time, particles);
    const Penetration mine = walls.penetration();
    const std::int64_t count = session_.comm().sum(mine.count);
    const double deepest = session_.comm().max(mine.deepest);
    worst_ = {std::max(worst_.count, count), std::max(worst_.deepest, deepest)};
    if (deepest > 0.05 && session_.is_root()) {
        session_.log().warn(
            base::text("t = ", now.time, " s: ", count, " particles inside walls, the deepest ", deepest, " dx"));
    }
}

template<int D> void FluidOutput<D>::summarise(base::JsonObject& figures) const
{
    figures.set("mass_error", largest_mass_error_)
        .set("particles_inside_walls_most", worst_.count)
        .set("deepest_penetration_dx", worst_.deepest);
}

template class FluidOutput<2>;
template class FluidOutput<3>;

} // namespace sph

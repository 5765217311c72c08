// SPDX-License-Identifier: MIT
#include "sph_solver/fluid_simulation.hpp"

#include "sph_solver/data_flow.hpp"
#include "sph_solver/operators/viscous_force.hpp"
#include "sph_solver/output/state_hash.hpp"
#include "sph_solver/setup/initial_state.hpp"
#include "sph_solver/setup/make_model.hpp"
#include "sph_solver/setup/rigid_walls.hpp"

namespace sph {
namespace {

constexpr double deepest_start = 0.05; // [dx] into a wall that a particle may start

double end_time(const FluidConfig& config, const coupler::Session& session)
{
    if (session.coupled()) return session.coupling().time.end;
    base::require_input(config.time.end > config.time.start, "[time] end = ", config.time.end,
                        " s is not after the start (", config.time.start, " s); a fluid that runs alone needs it");
    return config.time.end;
}

template<int D> NeighbourSearch<D> make_search(const FluidConfig& config, const FluidModel<D>& model)
{
    const double support = model.kernel.support();
    return {support, config.resolution.skin * support};
}

template<int D> Outflow<D> make_outflow(const FluidConfig& config, const FluidModel<D>& model)
{
    std::vector<OutflowPlane<D>> planes;
    for (const OutflowConfig& outflow : config.outflows) {
        planes.push_back(
            {Eigen::Map<const Vec<D>>(outflow.point.data()), Eigen::Map<const Vec<D>>(outflow.normal.data())});
    }
    return {planes, model.eos, model.gravity};
}

/// How the fluid lies on the ranks at the end, and how it was cut. Collective.
template<int D> base::JsonObject parallel_figures(const Domain<D>& domain, const Particles<D>& particles)
{
    const auto& comm = domain.comm();
    const auto owned = static_cast<double>(particles.owned.size());
    const double halo = static_cast<double>(particles.size()) - owned;
    base::JsonObject figures;
    figures.set("cuts", domain.balance().cuts())
        .set("cuts_declined", domain.balance().declined())
        .set("imbalance_mean", domain.balance().mean())
        .set("imbalance_last", domain.balance().present())
        .set("blocks", static_cast<std::int64_t>(domain.blocks().size()))
        .set("particles_most", comm.max(owned))
        .set("particles_least", comm.min(owned))
        .set("particles_least_ever", comm.min(static_cast<double>(domain.least_owned())))
        .set("halo_most", comm.max(halo))
        .set("halo_all_ranks", comm.sum(halo));
    return figures;
}

TimeStepSettings step_settings(const FluidConfig& config, const coupler::Session& session)
{
    return {config.time.cfl,
            config.resolution.smoothing_length(),
            config.liquid.sound_speed,
            config.time.fixed_dt,
            config.liquid.viscosity / config.liquid.density,
            session.coupled() ? session.coupling().scheme.solid_every : 1};
}

} // namespace

template<int D>
FluidSimulation<D>::FluidSimulation(const FluidConfig& config, coupler::Session& session)
    : config_(config),
      session_(session),
      model_(make_model<D>(config)),
      end_time_(end_time(config, session)),
      walls_(make_walls(config, model_, end_time_)),
      search_(make_search(config, model_)),
      domain_(session.comm(), search_.grid(), {config.parallel.imbalance_limit, config.parallel.rebuilds_between}),
      outflow_(make_outflow(config, model_)),
      step_(model_, RungeKutta(config.numerics.integrator), {domain_, search_, walls_, outflow_, session.timers()}),
      ledger_(model_),
      time_step_(step_settings(config, session)),
      particles_(initial_particles<D>(config, model_, session.comm())),
      progress_(session.log(), config.time.start, end_time_)
{
    now_.time = config.time.start;
    step_.add_observer(ledger_);
    if (config.liquid.viscosity > 0.0)
        step_.add_term(std::make_unique<ViscousForce<D>>(config.liquid.viscosity, model_));
}

template<int D> void FluidSimulation<D>::check()
{
    step_.prepare(particles_);
    require_dry_walls(walls_, session_.comm(), deepest_start);
    const auto count = session_.comm().sum(static_cast<std::int64_t>(particles_.owned.size()));
    session_.log().info(base::text("the input is in order: ", count, " particles in ", D, "D"));
    if (session_.coupled()) session_.check_flow(data_flow(config_, session_));
}

template<int D> void FluidSimulation<D>::run()
{
    output_ = std::make_unique<FluidOutput<D>>(config_, session_, model_);
    if (session_.coupled()) {
        solid_ = std::make_unique<SolidLink<D>>(session_, model_, search_, walls_);
        step_.add_observer(solid_->observer());
    }
    start();
    const base::Stopwatch watch;
    while (!now_.last) {
        advance();
        write();
        exchange();
    }
    loop_seconds_ = watch.seconds();
    finish();
}

/// The state at the start, the load that it puts on the solid, and the first rows.
template<int D> void FluidSimulation<D>::start()
{
    if (solid_) {
        domain_.redistribute(particles_); // a rank's region is known only now
        solid_->greet(particles_, now_.time);
    }
    step_.prepare(particles_);
    require_dry_walls(walls_, session_.comm(), deepest_start);
    next_dt_ = time_step_.next(particles_, session_.comm());
    if (solid_) solid_->measure_start(step_, particles_);
    write();
    exchange();
}

template<int D> void FluidSimulation<D>::advance()
{
    const auto scope = session_.timers().scope("step");
    session_.participant().set_clock(now_.step, now_.time);
    session_.participant().check_signals();
    try {
        walls_.start_step(now_.time);
        step_.advance(particles_, next_dt_);
        updates_ += static_cast<double>(particles_.owned.size());
        now_ = {now_.step + 1, now_.time + next_dt_, next_dt_, false};
        next_dt_ = time_step_.next(particles_, session_.comm());
    } catch (const base::Error& error) {
        if (error.code() != base::ExitCode::numerical_failure) throw;
        throw base::Error(error.code(), base::text(error.what(), " (fluid rank ", session_.comm().rank(), ", step ",
                                                   now_.step + 1, ", t = ", now_.time, " s)"));
    }
    stopping_ = stop_wanted();
    now_.last = is_last();
    progress_.update(now_.time, now_.step, now_.dt);
}

template<int D> bool FluidSimulation<D>::is_last() const
{
    return meets_solid() && (stopping_ || now_.time >= end_time_ * (1.0 - 1e-12));
}

/// With several steps for one of the solid, only some end with an exchange.
template<int D> bool FluidSimulation<D>::meets_solid() const { return !solid_ || solid_->due(now_.step); }

/// Coupled, both sides agree on it with their packets; alone, the ranks do.
template<int D> bool FluidSimulation<D>::stop_wanted()
{
    if (solid_) return solid_->stop_agreed();
    return session_.comm().any(session_.participant().stop_requested());
}

template<int D> void FluidSimulation<D>::exchange()
{
    if (!solid_) return;
    const auto scope = session_.timers().scope("exchange");
    row_wanted_ = row_wanted_ || output_->row_due();
    if (!meets_solid()) return solid_->coast(now_.dt);
    if (!now_.last && now_.step > 0) step_.settle(particles_, next_dt_); // asks for facets where the particles will be
    solid_->exchange({now_.step, now_.time, next_dt_, now_.last, stopping_}, particles_);
    if (row_wanted_) solid_->write_row();
    row_wanted_ = false;
}

template<int D> void FluidSimulation<D>::write()
{
    output_->look_at(now_);
    if (!output_->row_due() && !output_->fields_due()) return;
    const auto scope = session_.timers().scope("output");
    if (output_->row_due()) {
        const EnergyBalance energies = ledger_.balance(particles_, outflow_, session_.comm());
        output_->write_row(now_, energies, particles_);
        if (solid_) solid_->report(energies);
    }
    if (output_->fields_due()) {
        walls_.find_contacts(particles_);
        output_->write_fields(now_, particles_, walls_);
    }
}

template<int D> void FluidSimulation<D>::finish()
{
    progress_.finish();
    const auto& comm = session_.comm();
    base::JsonObject figures;
    const double updates = comm.sum(updates_);
    figures.set("dimension", D)
        .set("particles", comm.sum(static_cast<std::int64_t>(particles_.owned.size())))
        .set("particles_gone", comm.sum(outflow_.totals().particles))
        .set("particles_trapped", comm.sum(outflow_.trapped().particles))
        .set("steps", now_.step)
        .set("end_time", now_.time)
        .set("particle_updates_per_s", loop_seconds_ > 0.0 ? updates / loop_seconds_ : 0.0)
        .set("rebuilds", static_cast<std::int64_t>(step_.rebuilds()))
        .set("parallel", parallel_figures(domain_, particles_))
        .set("state_hash", state_hash(particles_, comm));
    output_->summarise(figures);
    if (solid_) solid_->summarise(figures);
    session_.write_summary(figures);
}

template class FluidSimulation<2>;
template class FluidSimulation<3>;

} // namespace sph

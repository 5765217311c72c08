// SPDX-License-Identifier: MIT
#include "sph_solver/time/fluid_step.hpp"

#include "sph_solver/operators/derived_fields.hpp"
#include "sph_solver/operators/fluid_flux.hpp"
#include "sph_solver/operators/fluid_gradients.hpp"
#include "sph_solver/operators/shifting.hpp"
#include "sph_solver/operators/wall_gradients.hpp"
#include "sph_solver/time/work_costs.hpp"
#include "sph_solver/walls/trapped.hpp"

#include <algorithm>
#include <cmath>

namespace sph {

template<int D> void FluidStep<D>::advance(Particles<D>& particles, double dt)
{
    if (!settled_) settle(particles, dt); // who left my region
    refresh_neighbourhood(particles, dt); // who sees whom
    for (auto* observer : observers_) observer->begin_step(particles, parts_.walls, dt);
    update_.start(particles);
    for (const Stage& stage : runge_kutta_.stages()) {
        parts_.walls.move(stage.time * dt); // X + V s + A s^2 / 2
        evaluate(particles, stage.slopes);
        if (stage.weight != 0.0)
            for (auto* observer : observers_) observer->observe(particles, parts_.walls, evaluation_, stage.weight, dt);
        const auto part = measure("stage", Work::particle);
        update_.apply(particles, stage, evaluation_.rates, dt);
        parts_.domain.start_state(particles); // position, volume, mass, momentum for the halo copies
        update_derived(particles, model_.eos, particles.owned);
    }
    parts_.walls.move(dt);
    settled_ = false;
}

template<int D> const Evaluation<D>& FluidStep<D>::evaluate(Particles<D>& particles, Slopes slopes)
{
    const RowSet inner(particles.owned, split_.inner), border(particles.owned, split_.border);
    find_planes(particles);
    in_reach_.start(particles, parts_.search.list());
    evaluation_.rates.reset(particles.size());
    evaluation_.viscous.assign(terms_.empty() ? 0 : particles.owned.size(), Vec<D>::Zero());
    meet(particles, particles.owned, inner);
    if (slopes == Slopes::made)
        find_rates_with_new_slopes(particles, inner, border);
    else
        find_rates_with_kept_slopes(particles, inner, border);
    second_pass_at_walls(particles);
    ++evaluations_;
    return evaluation_;
}

template<int D>
void FluidStep<D>::find_rates_with_new_slopes(Particles<D>& particles, const RowSet& inner, const RowSet& border)
{
    first_pass(inner); // while the state of the halo copies is on its way
    complete_state(particles);
    meet(particles, split_.halo, border);
    first_pass(border);
    first_pass_at_walls(particles);
    parts_.domain.start_gradients(particles);
    second_pass(inner); // while their gradients are
    complete_gradients(particles);
    second_pass(border);
}

template<int D>
void FluidStep<D>::find_rates_with_kept_slopes(Particles<D>& particles, const RowSet& inner, const RowSet& border)
{
    second_pass(inner); // while the state of the halo copies is on its way
    complete_state(particles);
    meet(particles, split_.halo, border);
    find_images(particles);
    second_pass(border);
}

template<int D> void FluidStep<D>::find_planes(const Particles<D>& particles)
{
    const auto part = measure("walls: find planes", Work::image);
    parts_.walls.find_contacts(particles);
}

/// Who is near whom among some rows, when the particles `which` have got their state.
template<int D>
void FluidStep<D>::meet(const Particles<D>& particles, const std::vector<int>& which, const RowSet& rows)
{
    const auto part = measure("neighbours in reach", Work::pair);
    in_reach_.take_positions(particles, which);
    in_reach_.select(parts_.search.list(), rows);
    records_.load_states(particles, model_.eos, which);
}

/// Sums over the fluid pairs of some rows.
template<int D> void FluidStep<D>::first_pass(const RowSet& rows)
{
    const auto part = measure("pass 1: gradients", Work::pair);
    accumulate_fluid_gradients(gradient_sums_, records_, in_reach_.reached(), rows, model_);
}

template<int D> void FluidStep<D>::find_images(const Particles<D>& particles)
{
    const auto part = measure("walls: images", Work::image);
    images_.find(parts_.walls, records_, particles, in_reach_.reached());
}

template<int D> void FluidStep<D>::first_pass_at_walls(Particles<D>& particles)
{
    find_images(particles);
    {
        const auto part = measure("pass 1: walls", Work::image);
        accumulate_wall_gradients(gradient_sums_, images_, parts_.walls, records_, model_);
    }
    const auto part = measure("pass 1: finish", Work::particle);
    finish_gradients(particles, gradient_sums_, model_);
    find_shifts(particles, records_, in_reach_.reached(), gradient_sums_, parts_.walls, model_);
    records_.load_slopes(particles, model_, particles.owned);
}

/// Fluxes through the faces of some rows, when all their particles have got their slopes.
template<int D> void FluidStep<D>::second_pass(const RowSet& rows)
{
    const auto part = measure("pass 2: fluxes", Work::pair);
    const auto scratch = std::as_writable_bytes(std::span(gradient_sums_)); // their slopes are made
    add_fluid_fluid_flux(evaluation_.rates, evaluation_.fluxes, records_, in_reach_.reached(), rows, model_, scratch);
    for (const auto& term : terms_)
        term->add(evaluation_.rates, evaluation_.viscous, records_, in_reach_.reached(), rows);
}

template<int D> void FluidStep<D>::second_pass_at_walls(const Particles<D>& particles)
{
    const auto part = measure("pass 2: walls", Work::image);
    find_wall_forces(evaluation_.wall_forces, images_, parts_.walls, records_, model_);
    for (const auto& term : terms_) term->add_at_walls(evaluation_.wall_forces, images_, parts_.walls, records_);
    add_wall_forces(evaluation_.rates, evaluation_.wall_forces, parts_.walls);
    add_gravity(evaluation_.rates, particles, model_.gravity);
}

/// Waits for what the halo copies' owners have sent after the last stage, if they have.
template<int D> void FluidStep<D>::complete_state(Particles<D>& particles)
{
    const auto scope = parts_.timers.scope("halo: wait for the state");
    parts_.domain.finish_state(particles);
    update_derived(particles, model_.eos, split_.halo);
}

template<int D> void FluidStep<D>::complete_gradients(Particles<D>& particles)
{
    const auto scope = parts_.timers.scope("halo: wait for gradients");
    parts_.domain.finish_gradients(particles);
    records_.load_slopes(particles, model_, split_.halo);
}

template<int D> void FluidStep<D>::prepare(Particles<D>& particles)
{
    redistribute(particles);
    build_lists(particles);
    parts_.walls.find_contacts(particles);
    settled_ = true;
}

template<int D> void FluidStep<D>::settle(Particles<D>& particles, double dt)
{
    settled_ = true;
    if (!lists_hold(particles, dt)) redistribute(particles);
}

template<int D> void FluidStep<D>::refresh_neighbourhood(const Particles<D>& particles, double dt)
{
    if (redistributed_)
        build_lists(particles);
    else if (!walls_hold(dt))
        prepare_walls(particles);
    else
        parts_.walls.renew_touching();
}

/// Will lists and halo still be complete at the end of the step, for a bound on all motion? Collective.
///
/// The farthest and the fastest particle may be on two ranks: each is found among all before they are added up, or
/// the partition would decide when lists are made.
///
/// Asks the particles alone: which facets a rank knows depends on the partition, when lists are made must not. (Water
/// that a plate keeps apart moves with it, so the pairs it separates stay the same as well.)
template<int D> bool FluidStep<D>::lists_hold(const Particles<D>& particles, double dt) const
{
    double fastest = 0.0;
    for (const int i : particles.owned)
        fastest = std::max(fastest, particle_velocity(particles, static_cast<std::size_t>(i)).squaredNorm());
    const auto& comm = parts_.domain.comm();
    const double displacement = comm.max(parts_.search.largest_displacement(particles));
    return displacement + std::sqrt(comm.max(fastest)) * dt <= 0.5 * parts_.search.skin();
}

/// Will the particles near walls still be known at the end of the step?
template<int D> bool FluidStep<D>::walls_hold(double dt) const
{
    if (parts_.walls.stale()) return false;
    parts_.walls.move(dt);
    const double displacement = parts_.walls.largest_displacement();
    parts_.walls.move(0.0); // where every rank has them, whichever had to look
    return displacement <= 0.5 * parts_.search.skin();
}

template<int D> void FluidStep<D>::prepare_walls(const Particles<D>& particles)
{
    parts_.walls.move(0.0);
    parts_.walls.prepare(particles, parts_.search.skin());
}

template<int D> void FluidStep<D>::redistribute(Particles<D>& particles)
{
    const auto scope = parts_.timers.scope("migration and halo");
    complete_state(particles);
    report_work(particles);
    remove_trapped_and_gone(particles);
    parts_.domain.redistribute(particles);
    update_derived(particles, model_.eos);
    redistributed_ = true;
}

/// The planes are those of the last evaluation, half a step old.
template<int D> void FluidStep<D>::remove_trapped_and_gone(Particles<D>& particles)
{
    const WallSettings<D>& settings = parts_.walls.settings();
    const double gap = settings.trap_gap * settings.spacing;
    parts_.outflow.remove(particles, find_trapped(parts_.walls.contacts(), gap, particles.owned.size()));
}

/// What the last evaluation had to do, where it was, and what those since the last report, all much alike, have cost.
template<int D> void FluidStep<D>::report_work(const Particles<D>& particles)
{
    if (evaluations_ == 0) return;
    meter_.add_counts(count_work(in_reach_.reached(), parts_.walls.contacts()), evaluations_);
    const double measured = meter_.calibrate(parts_.domain.comm());
    const auto costs = work_costs(meter_, in_reach_.reached(), parts_.walls.contacts());
    parts_.domain.record_work(particles, costs, measured);
    evaluations_ = 0;
}

template<int D> void FluidStep<D>::build_lists(const Particles<D>& particles)
{
    const auto scope = parts_.timers.scope("neighbours");
    prepare_walls(particles);
    const Walls<D>& walls = parts_.walls;
    parts_.search.build(
        particles, {.concerns = [&](const Vec<D>& x) { return walls.may_separate(x); },
                    .lets_pass = [&](const Vec<D>& x_i, const Vec<D>& x_j) { return walls.may_interact(x_i, x_j); }});
    split_.find(parts_.search.list(), particles.is_owned);
    redistributed_ = false;
    ++rebuilds_;
}

template class FluidStep<2>;
template class FluidStep<3>;

} // namespace sph

// SPDX-License-Identifier: MIT
// What a coupled run of the solid does beyond one that is alone.
#include "fem_solver/solid_simulation.hpp"

namespace fem {
namespace {

InterfaceLoadSettings load_settings(const coupler::InterfaceConfig& interface, const coupler::SchemeConfig& scheme)
{
    return {interface.load_kind() == coupler::LoadKind::averaged, scheme.impedance_share()};
}

int acceleration_steps(const coupler::SchemeConfig& scheme)
{
    return scheme.acceleration == "nodal" ? 0 : scheme.acceleration_steps;
}

} // namespace

void SolidSimulation::run_coupled()
{
    const coupler::SchemeConfig& scheme = session_.coupling().scheme;
    const coupler::InterfaceConfig interface = session_.coupling().interface_of(session_.role());
    prepare();
    loads_.emplace(model_.mesh(), *boundary_, model_.forces(), load_settings(interface, scheme));
    fluid_.emplace(session_.participant(), interface.settings(session_.role()), *boundary_, acceleration_steps(scheme),
                   scheme.load_prediction());
    answer(fluid_->receive()); // greeting: where the body is
    answer_first(fluid_->receive());
    scheme.serial() ? follow_the_fluid() : keep_pace_with_the_fluid();
    finish(base::JsonObject()
               .set("wait_s", fluid_->wait_seconds())
               .set("bytes_received", fluid_->bytes_received())
               .set("loads_hash", fluid_->loads_hash()));
}

/// The state at the start, from the load that the fluid bears down with there.
void SolidSimulation::answer_first(const coupler::Window& window)
{
    loads_->start(fluid_->load());
    step_.start(motion_);
    show(window);
}

/// Parallel: both compute the window's step at the same time, the solid with the load of the fluid's last one.
void SolidSimulation::keep_pace_with_the_fluid()
{
    while (!window_.last) {
        step_under_load(window_.dt);
        show(fluid_->receive());
    }
}

/// Serial: the fluid is a step ahead; the solid makes the same step with the load of it, while the fluid waits.
void SolidSimulation::follow_the_fluid()
{
    while (!window_.last) {
        const coupler::Window next = fluid_->receive();
        step_under_load(window_.dt);
        show(next);
    }
}

void SolidSimulation::step_under_load(double dt)
{
    loads_->set(fluid_->predict_load(motion_, dt), motion_);
    advance(dt);
}

/// Sends and writes the state of the window's time.
void SolidSimulation::show(const coupler::Window& window)
{
    window_ = window;
    now_ = {window.time, window.step, now_.dt, window.last};
    answer(window);
    write();
}

/// Sends the motion that belongs to the window's time.
void SolidSimulation::answer(const coupler::Window& window)
{
    const auto scope = session_.timers().scope("send");
    fluid_->send(window.time, motion_, report());
}

coupler::SolidReport SolidSimulation::report() const
{
    const SolidEnergies& e = step_.energies();
    const Resultants load = resultants(model_.mesh(), motion_, step_.forces().interface + step_.forces().correction);
    coupler::SolidReport report;
    report.force = load.force;
    report.moment = load.moment;
    report.work = e.work_interface;
    report.displacement_max = boundary_->largest_displacement(motion_);
    report.kinetic = e.kinetic;
    report.strain = e.strain;
    report.potential = e.potential;
    report.external_work = e.work_supports + e.work_loads + e.contact;
    report.dissipated = e.damping + e.numerical_dissipation + e.friction;
    return report;
}

} // namespace fem

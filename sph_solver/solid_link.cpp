// SPDX-License-Identifier: MIT
#include "sph_solver/solid_link.hpp"

#include "sph_solver/interface/interface_geometry.hpp"

#include <algorithm>
#include <limits>

namespace sph {
namespace {

/// A load beyond rho0 c0^2 would need water hitting the surface at the speed of sound: the computation has diverged.
coupler::InterfaceSettings settings(const coupler::Session& session, const Tait& eos)
{
    coupler::InterfaceSettings result = session.coupling().interface_settings();
    result.impedance = eos.rho0 * eos.c0;
    result.pressure_limit = eos.rho0 * eos.c0 * eos.c0;
    return result;
}

/// The smallest box around two; an empty one adds nothing.
coupler::RegionBox united(coupler::RegionBox a, const coupler::RegionBox& b)
{
    for (std::size_t d = 0; d < 3; ++d) {
        a.low[d] = std::min(a.low[d], b.low[d]);
        a.high[d] = std::max(a.high[d], b.high[d]);
    }
    return a;
}

/// Particles may change ranks before the next exchange: each rank then wants the whole surface.
coupler::RegionBox everywhere()
{
    constexpr double far = std::numeric_limits<double>::max();
    return {{-far, -far, -far}, {far, far, far}};
}

} // namespace

template<int D>
SolidLink<D>::SolidLink(coupler::Session& session, const FluidModel<D>& model, const NeighbourSearch<D>& search,
                        Walls<D>& walls)
    : session_(session),
      walls_(walls),
      steps_(session.coupling().scheme.solid_every),
      region_margin_(search.reach() + search.skin() + walls.settings().spacing),
      region_step_(search.reach()),
      interface_(session.participant(), settings(session, model.eos), D),
      observer_(walls.settings(), session.coupling().interface_settings().load == coupler::LoadKind::averaged, steps_)
{
    batch_.dimension = D;
    if (session.is_root()) record_.emplace(session.output_dir(), D);
}

template<int D> void SolidLink<D>::greet(const Particles<D>& particles, double time)
{
    send({.step = -1, .time = time}, particles, {});
    receive();
    move_walls();
}

template<int D> void SolidLink<D>::measure_start(FluidStep<D>& step, Particles<D>& particles)
{
    observer_.begin_step(particles, walls_, 0.0);
    const Evaluation<D>& evaluation = step.evaluate(particles);
    observer_.observe(particles, walls_, evaluation, 1.0, 0.0);
    const double spacing = walls_.settings().spacing;
    mapping_ = examine_mapping(walls_, batch_, spacing, session_.comm());
    session_.log().info(describe(mapping_, session_.coupling().interface.surface, D, spacing));
}

template<int D>
void SolidLink<D>::exchange(const coupler::Window& step, const Particles<D>& particles, const EnergyLedger<D>& ledger)
{
    coupler::Window window = step;
    window.step /= steps_;
    window.dt *= steps_;
    sum_load(ledger);
    send(window, particles, observer_.loads());
    const coupler::FacetBatch before = batch_;
    receive();
    if (window.step > 0) {
        const auto jump = jump_work(observer_.loads(), walls_, before, batch_);
        report_.jump_work += session_.comm().total(jump).value();
    }
    move_walls();
    if (record_) record_->add(window, report_, solid_);
}

/// x += v dt + a dt^2/2, v += a dt
template<int D> void SolidLink<D>::coast(double dt)
{
    coupler::SurfaceMotion& motion = batch_.motion;
    for (std::size_t k = 0; k < motion.position.size(); ++k) {
        motion.position[k] += dt * (motion.velocity[k] + 0.5 * dt * motion.acceleration[k]);
        motion.velocity[k] += dt * motion.acceleration[k];
    }
    set_interface_motion(walls_, batch_);
}

template<int D>
void SolidLink<D>::send(const coupler::Window& window, const Particles<D>& particles, const coupler::FacetLoads& loads)
{
    const auto scope = session_.timers().scope("interface: send");
    const coupler::RegionBox region = steps_ == 1 ? region_of(particles, region_margin_, region_step_) : everywhere();
    interface_.send(window, united(region, last_region_), loads, batch_, report_);
    last_region_ = region;
}

template<int D> void SolidLink<D>::receive()
{
    const auto scope = session_.timers().scope("interface: wait for the solid");
    batch_ = interface_.receive(solid_);
}

template<int D> void SolidLink<D>::move_walls()
{
    set_interface_motion(walls_, batch_);
    observer_.set_facet_count(batch_.facet_ids.size());
}

/// Force, moment and work that travel with the load: sums over all ranks.
template<int D> void SolidLink<D>::sum_load(const EnergyLedger<D>& ledger)
{
    const Resultant load = resultant(observer_.loads(), walls_, batch_, session_.comm());
    report_.force = load.force;
    report_.moment = load.moment;
    report_.work_on_solid = -session_.comm().total(ledger.work_by_interface()).value();
    report_.wait = session_.comm().max(interface_.wait_seconds());
}

template<int D> void SolidLink<D>::report(const EnergyBalance& energies)
{
    report_.kinetic = energies.kinetic;
    report_.potential = energies.potential;
    report_.internal = energies.internal;
    report_.external_work = energies.work_by_walls;
    report_.outflow = energies.outflow_energy;
    report_.dissipated =
        energies.dissipation_riemann + energies.dissipation_mass_flux + energies.dissipation_walls + energies.viscous;
}

template<int D> void SolidLink<D>::write_row()
{
    if (record_) record_->write();
}

template<int D> void SolidLink<D>::summarise(base::JsonObject& figures) const
{
    const auto& comm = session_.comm();
    const std::int64_t bytes = interface_.bytes_received();
    figures.set("wait_s", comm.max(interface_.wait_seconds()))
        .set("bytes_received_most", comm.max(bytes))
        .set("bytes_received_least", -comm.max(-bytes))
        .set("bytes_sent_all_ranks", comm.sum(interface_.bytes_sent()));
    figures.set("mapping", base::JsonObject()
                               .set("facets", mapping_.facets)
                               .set("facets_touched", mapping_.touched)
                               .set("area", mapping_.area)
                               .set("wall_points", mapping_.points)
                               .set("first_layer_dx", mapping_.layer)
                               .set("nearest_dx", mapping_.nearest)
                               .set("constant_error", mapping_.constant_error)
                               .set("turn_error_dx", mapping_.centre_distance));
    if (!record_) return;
    figures.set("interface_work_mismatch", record_->audit().worst_mismatch())
        .set("energy_drift", record_->energy_drift());
}

template class SolidLink<2>;
template class SolidLink<3>;

} // namespace sph

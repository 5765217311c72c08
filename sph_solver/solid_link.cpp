// SPDX-License-Identifier: MIT
#include "sph_solver/solid_link.hpp"

#include <algorithm>
#include <limits>

namespace sph {
namespace {

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

bool any_averaged(const coupler::CouplingConfig& coupling)
{
    return std::ranges::any_of(coupling.interfaces, [](const coupler::InterfaceConfig& one) {
        return one.load_kind() == coupler::LoadKind::averaged;
    });
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
      observer_(walls.settings(), any_averaged(session.coupling()), steps_)
{
    for (const coupler::InterfaceConfig& one : session.coupling().interfaces_of(session.role()))
        interfaces_.push_back(
            std::make_unique<WetInterface<D>>(session, one, model.eos, observer_, interfaces_.size()));
    if (session.is_root()) record_.emplace(session.output_dir(), D);
}

template<int D> void SolidLink<D>::greet(const Particles<D>& particles, double time)
{
    send({.step = -1, .time = time}, particles);
    receive();
    move_walls();
}

template<int D> void SolidLink<D>::measure_start(FluidStep<D>& step, Particles<D>& particles)
{
    observer_.begin_step(particles, walls_, 0.0);
    const Evaluation<D>& evaluation = step.evaluate(particles);
    observer_.observe(particles, walls_, evaluation, 1.0, 0.0);
    for (const auto& interface : interfaces_) interface->examine(walls_);
}

template<int D> void SolidLink<D>::exchange(const coupler::Window& step, const Particles<D>& particles)
{
    coupler::Window window = step;
    window.step /= steps_;
    window.dt *= steps_;
    for (const auto& interface : interfaces_) interface->sum_load(walls_);
    send(window, particles);
    receive();
    if (window.step > 0)
        for (const auto& interface : interfaces_) interface->sum_works(walls_);
    move_walls();
    add_to_records(window);
}

template<int D> void SolidLink<D>::coast(double dt)
{
    for (const auto& interface : interfaces_) interface->coast(dt);
    move_walls();
}

template<int D> void SolidLink<D>::send(const coupler::Window& window, const Particles<D>& particles)
{
    const auto scope = session_.timers().scope("interface: send");
    const coupler::RegionBox region = steps_ == 1 ? region_of(particles, region_margin_, region_step_) : everywhere();
    for (const auto& interface : interfaces_) interface->send(window, united(region, last_region_), energies_);
    last_region_ = region;
}

template<int D> void SolidLink<D>::receive()
{
    const auto scope = session_.timers().scope("interface: wait for the solid");
    for (const auto& interface : interfaces_) interface->receive();
}

template<int D> void SolidLink<D>::move_walls()
{
    InterfacePlace behind;
    std::vector<std::size_t> ends;
    std::vector<const coupler::FacetBatch*> batches;
    for (const auto& interface : interfaces_) {
        behind = interface->take_place(behind);
        ends.push_back(behind.facet);
        batches.push_back(&interface->batch());
    }
    set_interface_motion(walls_, joined(batches));
    observer_.set_interfaces(std::move(ends));
}

template<int D> void SolidLink<D>::add_to_records(const coupler::Window& window)
{
    std::vector<coupler::SolidReport> solids;
    for (const auto& interface : interfaces_) {
        interface->add_to_record(window);
        solids.push_back(interface->solid());
    }
    if (record_) record_->add(window.time, energies_, solids);
}

template<int D> void SolidLink<D>::report(const EnergyBalance& energies)
{
    energies_.kinetic = energies.kinetic;
    energies_.potential = energies.potential;
    energies_.internal = energies.internal;
    energies_.external_work = energies.work_by_walls;
    energies_.outflow = energies.outflow_energy;
    energies_.dissipated =
        energies.dissipation_riemann + energies.dissipation_mass_flux + energies.dissipation_walls + energies.viscous;
}

template<int D> void SolidLink<D>::write_row()
{
    for (const auto& interface : interfaces_) interface->write_row();
    if (record_) record_->write();
}

template<int D> bool SolidLink<D>::stop_agreed() const
{
    return std::ranges::any_of(interfaces_, [](const auto& interface) { return interface->stop_agreed(); });
}

template<int D> void SolidLink<D>::summarise(base::JsonObject& figures) const
{
    double wait = 0, mismatch = 0;
    base::JsonObject all;
    for (const auto& interface : interfaces_) {
        all.set(interface->partner(), interface->figures());
        wait += interface->wait_seconds();
        mismatch = std::max(mismatch, interface->mismatch());
    }
    figures.set("wait_s", session_.comm().max(wait)).set("interfaces", all);
    if (!record_) return;
    figures.set("interface_work_mismatch", mismatch).set("energy_drift", record_->drift());
}

template class SolidLink<2>;
template class SolidLink<3>;

} // namespace sph

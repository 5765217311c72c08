// SPDX-License-Identifier: MIT
#include "sph_solver/wet_interface.hpp"

namespace sph {
namespace {

/// A load beyond rho0 c0^2 would need water hitting the surface at the speed of sound: the computation has diverged.
coupler::InterfaceSettings settings(const coupler::InterfaceConfig& config, const std::string& role, const Tait& eos)
{
    coupler::InterfaceSettings result = config.settings(role);
    result.impedance = eos.rho0 * eos.c0;
    result.pressure_limit = eos.rho0 * eos.c0 * eos.c0;
    return result;
}

} // namespace

template<int D>
WetInterface<D>::WetInterface(coupler::Session& session, const coupler::InterfaceConfig& config, const Tait& eos,
                              const LoadObserver<D>& all, std::size_t number)
    : session_(session),
      config_(config),
      loads_(all),
      number_(number),
      exchange_(session.participant(), settings(config, session.role(), eos), D)
{
    batch_.dimension = D;
    const bool only_one = session.coupling().interfaces.size() == 1;
    if (session.is_root()) record_.emplace(coupler::interface_path(session.output_dir(), config.solid, only_one), D);
}

template<int D> InterfacePlace WetInterface<D>::take_place(const InterfacePlace& first)
{
    place_ = first;
    return {first.facet + batch_.facet_ids.size(), first.node + batch_.node_ids.size()};
}

template<int D>
void WetInterface<D>::send(const coupler::Window& window, const coupler::RegionBox& region,
                           const coupler::FluidEnergies& energies)
{
    static_cast<coupler::FluidEnergies&>(report_) = energies;
    const bool greeting = window.step < 0;
    const auto mine =
        greeting ? coupler::FacetLoads{} : part_of(loads_.loads(), place_.facet, batch_.facet_ids.size(), D);
    exchange_.send(window, region, mine, batch_, report_);
}

template<int D> void WetInterface<D>::receive()
{
    last_batch_ = std::move(batch_);
    last_batch_.motion.position = std::move(received_position_);
    batch_ = exchange_.receive(solid_);
    received_position_ = batch_.motion.position;
}

/// x += v dt + a dt^2/2, v += a dt
template<int D> void WetInterface<D>::coast(double dt)
{
    coupler::SurfaceMotion& motion = batch_.motion;
    for (std::size_t k = 0; k < motion.position.size(); ++k) {
        motion.position[k] += dt * (motion.velocity[k] + 0.5 * dt * motion.acceleration[k]);
        motion.velocity[k] += dt * motion.acceleration[k];
    }
}

template<int D> void WetInterface<D>::sum_load(const Walls<D>& walls)
{
    const auto& comm = session_.comm();
    const auto load = resultant(loads_.loads(), walls, batch_, place_);
    std::vector<base::ReproducibleSum> sums(load.begin(), load.end());
    sums.push_back(loads_.work(number_));
    sums = comm.total(sums);
    for (std::size_t a = 0; a < 3; ++a) {
        report_.force[a] = sums[a].value();
        report_.moment[a] = sums[3 + a].value();
    }
    report_.work_on_solid = sums[6].value();
    report_.wait = comm.max(exchange_.wait_seconds());
}

template<int D> void WetInterface<D>::sum_works(const Walls<D>& walls)
{
    const ExchangeWorks mine = exchange_works(loads_.loads(), walls, place_, last_batch_, batch_);
    const auto all = session_.comm().total({mine.jump, mine.path});
    report_.jump_work += all[0].value();
    report_.path_work += all[1].value();
}

template<int D> void WetInterface<D>::examine(const Walls<D>& walls)
{
    const double spacing = walls.settings().spacing;
    mapping_ = examine_mapping(walls, batch_, place_, spacing, session_.comm());
    session_.log().info(describe(mapping_, config_.surface, D, spacing));
}

template<int D> void WetInterface<D>::add_to_record(const coupler::Window& window)
{
    if (record_) record_->add(window, report_, solid_);
}

template<int D> void WetInterface<D>::write_row()
{
    if (record_) record_->write();
}

template<int D> base::JsonObject WetInterface<D>::figures() const
{
    const auto& comm = session_.comm();
    const std::int64_t bytes = exchange_.bytes_received();
    base::JsonObject figures;
    figures.set("surface", config_.surface)
        .set("wait_s", comm.max(exchange_.wait_seconds()))
        .set("bytes_received_most", comm.max(bytes))
        .set("bytes_received_least", -comm.max(-bytes))
        .set("bytes_sent_all_ranks", comm.sum(exchange_.bytes_sent()))
        .set("work_mismatch", mismatch())
        .set("facets", mapping_.facets)
        .set("facets_touched", mapping_.touched)
        .set("area", mapping_.area)
        .set("wall_points", mapping_.points)
        .set("first_layer_dx", mapping_.layer)
        .set("nearest_dx", mapping_.nearest)
        .set("constant_error", mapping_.constant_error)
        .set("turn_error_dx", mapping_.centre_distance);
    return figures;
}

template class WetInterface<2>;
template class WetInterface<3>;

} // namespace sph

// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/solid_interface.hpp"

#include "coupler_lib/coupling/checksum.hpp"
#include "coupler_lib/coupling/facet_routing.hpp"
#include "coupler_lib/coupling/load_packet.hpp"
#include "coupler_lib/coupling/packet_exchange.hpp"
#include "coupler_lib/coupling/participant.hpp"
#include "coupler_lib/coupling/surface_guards.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace coupler {
namespace {

/// Facet indices in ascending order of their ids.
std::vector<int> order_by_id(const std::vector<std::int64_t>& ids)
{
    std::vector<int> order(ids.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&ids](int a, int b) { return ids[static_cast<std::size_t>(a)] < ids[static_cast<std::size_t>(b)]; });
    return order;
}

/// Collective: every rank throws when one has a bad surface, or when a facet id occurs twice anywhere.
WetSurface checked(WetSurface surface, const Participant& participant)
{
    std::string problem;
    try {
        check_surface(surface, participant.name_of(participant.world_rank()));
    } catch (const base::Error& error) {
        problem = error.what();
    }
    auto ids = participant.comm().gather_all(surface.facet_ids);
    std::sort(ids.begin(), ids.end());
    const auto twice = std::adjacent_find(ids.begin(), ids.end());
    if (problem.empty() && twice != ids.end())
        problem = base::text("wet facet ", *twice, " occurs twice: facet ids must be unique over all ranks of '",
                             participant.role(), "'");
    const bool any = participant.comm().any(!problem.empty());
    base::require_input(!any, problem.empty() ? "another rank has a bad wet surface" : problem);
    base::require_input(!ids.empty(), "the wet surface of '", participant.role(), "' has no facet");
    return surface;
}

} // namespace

struct SolidInterface::Parts {
    Parts(Participant& participant_, InterfaceSettings settings_, WetSurface surface_)
        : participant(participant_),
          settings(std::move(settings_)),
          own_name(participant_.name_of(participant_.world_rank())),
          surface(checked(std::move(surface_), participant_)),
          order(order_by_id(surface.facet_ids)),
          exchange(participant_, participant_.partner_ranks(settings.partner), Field::motion),
          routes(exchange.size()),
          regions(exchange.size()),
          sum(surface),
          guard(surface, settings.motion_jump_limit),
          wall_velocity(surface.reference.size(), 0.0)
    {}

    PacketHeader expected_header(const PacketHeader& first) const;
    void remember_wall_velocity(const SurfaceMotion& motion);

    Participant& participant;
    InterfaceSettings settings;
    std::string own_name;
    WetSurface surface;
    std::vector<int> order; ///< facet indices by ascending id
    PacketExchange exchange;
    std::vector<FacetRoute> routes; ///< by fluid rank
    std::vector<RegionBox> regions; ///< by fluid rank, of the last packet
    LoadSum sum;
    MotionGuard guard;
    std::vector<double> wall_velocity;
    Window window;
    std::uint64_t loads_fingerprint = 0;
    bool begun = false;
    bool fluid_asks_to_stop = false;
};

/// The next packet's step and time follow from the last window; its dt is the fluid's to choose.
PacketHeader SolidInterface::Parts::expected_header(const PacketHeader& first) const
{
    PacketHeader expected = first;
    expected.dimension = surface.dimension;
    if (begun) {
        expected.step = window.step + 1;
        const double time = window.time + window.dt;
        if (std::abs(time - first.time) > 1e-9 * (window.dt + std::abs(time))) expected.time = time;
    } else {
        expected.step = -1;
    }
    return expected;
}

/// vbar = V + A dt/2: the mean velocity of the walls during the fluid step that starts with this motion.
void SolidInterface::Parts::remember_wall_velocity(const SurfaceMotion& motion)
{
    wall_velocity.resize(motion.velocity.size());
    for (std::size_t k = 0; k < wall_velocity.size(); ++k)
        wall_velocity[k] = motion.velocity[k] + 0.5 * window.dt * motion.acceleration[k];
}

SolidInterface::SolidInterface(Participant& participant, InterfaceSettings settings, WetSurface surface)
    : parts_(std::make_unique<Parts>(participant, std::move(settings), std::move(surface)))
{}

SolidInterface::~SolidInterface() = default;

Window SolidInterface::receive(SurfaceLoad& load, FluidReport& fluid)
{
    Parts& my = *parts_;
    my.exchange.receive_all(my.begun ? "the load" : "the greeting");
    my.sum.clear();
    my.fluid_asks_to_stop = false;
    PacketHeader first;
    for (std::size_t peer = 0; peer < my.exchange.size(); ++peer) {
        PacketReader packet(my.exchange.incoming(peer));
        if (peer == 0) first = packet.header();
        my.exchange.check(peer, packet.header(), my.expected_header(first));
        my.fluid_asks_to_stop = my.fluid_asks_to_stop || packet.header().has(sender_asked_to_stop);
        FluidReport report;
        packet.take(report);
        packet.take(my.regions[peer]);
        packet.take(load.impedance);
        my.sum.add(packet, my.routes[peer], my.exchange.name(peer));
        packet.finish();
        if (peer == 0) fluid = report;
    }
    my.begun = true;
    my.window = {first.step, first.time, first.dt, first.has(window_is_last), first.has(window_stops)};
    if (my.window.stop_requested) my.participant.request_stop(); // now every rank knows
    my.participant.set_clock(first.step, first.time);
    load.force.clear();
    load.pressure.clear();
    if (my.settings.load == LoadKind::conservative)
        my.sum.write_force(load.force);
    else
        my.sum.write_pressure(load.pressure, my.settings.coverage_limit);
    load.wall_velocity.swap(my.wall_velocity); // written anew by the next `send`
    const std::uint64_t so_far[] = {my.loads_fingerprint,
                                    checksum(load.force.data(), load.force.size() * sizeof(double)),
                                    checksum(load.pressure.data(), load.pressure.size() * sizeof(double))};
    my.loads_fingerprint = checksum(so_far, sizeof(so_far));
    return my.window;
}

void SolidInterface::send(const SurfaceMotion& motion, const SolidReport& report)
{
    Parts& my = *parts_;
    my.guard.check(my.surface, motion, my.own_name);
    PacketHeader header;
    header.step = my.window.step;
    header.time = my.window.time;
    header.dt = my.window.dt;
    header.dimension = my.surface.dimension;
    if (my.fluid_asks_to_stop || my.participant.stop_requested()) header.flags |= sender_asked_to_stop;
    const RegionBox all = box_around(motion.position, my.surface.dimension);
    for (std::size_t fluid = 0; fluid < my.exchange.size(); ++fluid) {
        PacketHeader mine = header;
        PacketWriter& packet = my.exchange.outgoing(fluid);
        packet.put(report);
        const bool changed = my.routes[fluid].choose(my.surface, my.order, motion, all, my.regions[fluid]);
        my.routes[fluid].write(my.surface, motion, changed, mine, packet);
        my.exchange.send(fluid, mine);
    }
    my.remember_wall_velocity(motion);
}

const WetSurface& SolidInterface::surface() const { return parts_->surface; }
std::string SolidInterface::loads_hash() const
{
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(parts_->loads_fingerprint));
    return digits;
}

double SolidInterface::wait_seconds() const { return parts_->exchange.wait_seconds(); }
std::int64_t SolidInterface::bytes_sent() const { return parts_->exchange.bytes_sent(); }
std::int64_t SolidInterface::bytes_received() const { return parts_->exchange.bytes_received(); }

} // namespace coupler

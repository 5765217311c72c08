// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/fluid_interface.hpp"

#include "coupler_lib/coupling/facet_routing.hpp"
#include "coupler_lib/coupling/load_packet.hpp"
#include "coupler_lib/coupling/packet_exchange.hpp"
#include "coupler_lib/coupling/participant.hpp"
#include "coupler_lib/coupling/surface_guards.hpp"

namespace coupler {
struct FluidInterface::Parts {
    Parts(Participant& participant_, InterfaceSettings settings_, int dimension)
        : participant(participant_),
          settings(std::move(settings_)),
          own_name(participant_.name_of(participant_.world_rank())),
          exchange(participant_, participant_.partner_ranks(settings.partner), Field::load),
          received(exchange.size()),
          load_writer(participant_.comm().size() == 1)
    {
        batch.dimension = dimension;
    }

    bool take_topology(std::vector<PacketReader>& packets);

    Participant& participant;
    InterfaceSettings settings;
    std::string own_name;
    PacketExchange exchange;
    std::vector<ReceivedFacets> received; ///< by solid rank
    LoadWriter load_writer;
    FacetBatch batch;
    Window window;
    bool stop_agreed = false;
};

FluidInterface::FluidInterface(Participant& participant, InterfaceSettings settings, int dimension)
    : parts_(std::make_unique<Parts>(participant, std::move(settings), dimension))
{}

FluidInterface::~FluidInterface() = default;

void FluidInterface::send(const Window& window, const RegionBox& my_region, const FacetLoads& loads,
                          const FacetBatch& used, const FluidReport& report)
{
    Parts& my = *parts_;
    my.participant.set_clock(window.step, window.time);
    check_load_sizes(loads, used, my.settings.load);
    base::require_input((loads.corner_force.empty() && loads.weight.empty()) ||
                            used.facet_ids.size() == my.batch.facet_ids.size(),
                        my.own_name, ": the load belongs to ", used.facet_ids.size(), " facets, but the solid sent ",
                        my.batch.facet_ids.size(), " last");
    PacketHeader header;
    header.step = window.step;
    header.time = window.time;
    header.dt = window.dt;
    header.dimension = my.batch.dimension;
    if (window.last) header.flags |= window_is_last;
    if (window.stop_requested) header.flags |= window_stops;
    if (my.participant.stop_requested()) header.flags |= sender_asked_to_stop;
    for (std::size_t solid = 0; solid < my.exchange.size(); ++solid) {
        PacketHeader mine = header;
        PacketWriter& packet = my.exchange.outgoing(solid);
        packet.put(report);
        packet.put(my_region);
        packet.put(my.settings.impedance);
        my.load_writer.write(my.received[solid], loads, my.batch.dimension, mine, packet);
        my.exchange.send(solid, mine);
    }
    check_loads(used, loads, my.settings.pressure_limit, my.own_name); // while the solid works
    my.window = window;
}

/// Reads ids and connectivity where they have changed. \return whether any have
bool FluidInterface::Parts::take_topology(std::vector<PacketReader>& packets)
{
    bool changed = false;
    for (std::size_t solid = 0; solid < packets.size(); ++solid) {
        const PacketHeader& header = packets[solid].header();
        if (!header.has(with_topology)) continue;
        changed = true;
        const auto facets = static_cast<std::size_t>(header.facets);
        packets[solid].take(received[solid].facet_ids, facets);
        packets[solid].take(received[solid].node_ids, static_cast<std::size_t>(header.nodes));
        packets[solid].take(received[solid].facet_nodes, facets);
    }
    return changed;
}

const FacetBatch& FluidInterface::receive(SolidReport& solid)
{
    Parts& my = *parts_;
    my.exchange.receive_all(my.window.step < 0 ? "the motion at the start" : "the motion");
    std::vector<PacketReader> packets;
    PacketHeader expected;
    expected.step = my.window.step;
    expected.time = my.window.time;
    expected.dt = my.window.dt;
    expected.dimension = my.batch.dimension;
    my.stop_agreed = false;
    for (std::size_t peer = 0; peer < my.exchange.size(); ++peer) {
        packets.emplace_back(my.exchange.incoming(peer));
        my.exchange.check(peer, packets.back().header(), expected);
        my.stop_agreed = my.stop_agreed || packets.back().header().has(sender_asked_to_stop);
        SolidReport report;
        packets.back().take(report);
        if (peer == 0) solid = report;
    }
    if (my.stop_agreed) my.participant.request_stop(); // now every rank knows
    if (my.take_topology(packets)) merge_topology(my.received, my.batch);
    for (std::size_t peer = 0; peer < packets.size(); ++peer) {
        merge_motion(my.received[peer], packets[peer], my.batch);
        packets[peer].finish();
    }
    return my.batch;
}

bool FluidInterface::stop_agreed() const { return parts_->stop_agreed; }
double FluidInterface::wait_seconds() const { return parts_->exchange.wait_seconds(); }
std::int64_t FluidInterface::bytes_sent() const { return parts_->exchange.bytes_sent(); }
std::int64_t FluidInterface::bytes_received() const { return parts_->exchange.bytes_received(); }

} // namespace coupler

// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/packet_exchange.hpp"

#include "coupler_lib/coupling/participant.hpp"

#include <cmath>
#include <exception>

namespace coupler {

PacketExchange::PacketExchange(Participant& participant, std::vector<int> peers, Field send_field)
    : participant_(participant),
      route_{std::move(peers), send_field},
      courier_(participant.make_courier(route_)),
      peers_(route_.peers.size()),
      incoming_(route_.peers.size())
{
    for (std::size_t peer = 0; peer < peers_.size(); ++peer)
        peers_[peer].name = participant.name_of(route_.peers[peer]);
}

PacketExchange::~PacketExchange()
{
    if (std::uncaught_exceptions() > 0) return; // the run ends by MPI_Abort; buffers are not needed any more
    try {
        for (std::size_t peer = 0; peer < peers_.size(); ++peer) courier_->await_taken(peer);
    } catch (const base::Error&) {
        // Nobody takes the last packet: the partner left. What mattered was reported by its own wait.
    }
}

PacketWriter& PacketExchange::outgoing(std::size_t peer)
{
    courier_->await_taken(peer);
    peers_[peer].outgoing.begin();
    return peers_[peer].outgoing;
}

void PacketExchange::send(std::size_t peer, PacketHeader header)
{
    Peer& to = peers_[peer];
    header.field = route_.send_field;
    header.sequence = to.sent++;
    to.outgoing.finish(header);
    courier_->send(peer, to.outgoing.bytes());
    bytes_sent_ += static_cast<std::int64_t>(to.outgoing.bytes().size());
}

void PacketExchange::receive_all(const char* what)
{
    waited_ += courier_->receive_all(what, incoming_);
    for (std::size_t peer = 0; peer < peers_.size(); ++peer) {
        ++peers_[peer].received;
        bytes_received_ += static_cast<std::int64_t>(incoming_[peer].size());
    }
}

void PacketExchange::check(std::size_t peer, const PacketHeader& got, PacketHeader expected) const
{
    expected.field = route_.receive_field();
    expected.sequence = peers_[peer].received - 1;
    const double slack = 1e-9 * std::abs(expected.dt);
    const bool same = got.field == expected.field && got.sequence == expected.sequence && got.step == expected.step &&
                      std::abs(got.time - expected.time) <= slack && std::abs(got.dt - expected.dt) <= slack &&
                      got.dimension == expected.dimension;
    if (same) return;
    throw base::Error(base::ExitCode::bad_input,
                      base::text(participant_.name_of(participant_.world_rank()), " expects the ", describe(expected),
                                 ", but ", name(peer), " sent the ", describe(got),
                                 ": the two sides have lost step with each other"));
}

} // namespace coupler

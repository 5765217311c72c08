// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/packet_exchange.hpp"

#include "coupler_lib/coupling/participant.hpp"

#include <cmath>
#include <exception>

namespace coupler {
namespace {

int tag_of(Field field) { return 100 + static_cast<int>(field); }

bool complete(MPI_Request& request)
{
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    return done != 0;
}

} // namespace

PacketExchange::PacketExchange(Participant& participant, std::vector<int> peers, Field send_field)
    : participant_(participant),
      peers_(peers.size()),
      send_field_(send_field),
      receive_field_(send_field == Field::load ? Field::motion : Field::load)
{
    for (std::size_t peer = 0; peer < peers.size(); ++peer) {
        peers_[peer].rank = peers[peer];
        peers_[peer].name = participant.name_of(peers[peer]);
    }
}

PacketExchange::~PacketExchange()
{
    if (std::uncaught_exceptions() > 0) return; // the run ends by MPI_Abort; buffers are not needed any more
    try {
        for (std::size_t peer = 0; peer < peers_.size(); ++peer) outgoing(peer);
    } catch (const base::Error&) {
        // Nobody takes the last packet: the partner left. What mattered was reported by its own wait.
    }
}

PacketWriter& PacketExchange::outgoing(std::size_t peer)
{
    Peer& to = peers_[peer];
    if (!complete(to.sending))
        participant_.wait_until([&to] { return complete(to.sending); }, "the last packet to be taken",
                                [&to] { return std::vector<int>{to.rank}; });
    to.outgoing.begin();
    return to.outgoing;
}

void PacketExchange::send(std::size_t peer, PacketHeader header)
{
    Peer& to = peers_[peer];
    header.field = send_field_;
    header.sequence = to.sent++;
    to.outgoing.finish(header);
    const auto bytes = to.outgoing.bytes();
    MPI_Isend(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to.rank, tag_of(send_field_),
              participant_.coupling_comm(), &to.sending);
    bytes_sent_ += static_cast<std::int64_t>(bytes.size());
}

bool PacketExchange::advance()
{
    bool all = true;
    for (Peer& from : peers_) {
        if (from.here) continue;
        if (from.receiving == MPI_REQUEST_NULL) {
            int arrived = 0;
            MPI_Message message{};
            MPI_Status status{};
            MPI_Improbe(from.rank, tag_of(receive_field_), participant_.coupling_comm(), &arrived, &message, &status);
            if (arrived) {
                int bytes = 0;
                MPI_Get_count(&status, MPI_BYTE, &bytes);
                from.incoming.resize(static_cast<std::size_t>(bytes));
                MPI_Imrecv(from.incoming.data(), bytes, MPI_BYTE, &message, &from.receiving);
                bytes_received_ += bytes;
            }
        }
        from.here = from.receiving != MPI_REQUEST_NULL && complete(from.receiving);
        all = all && from.here;
    }
    return all;
}

std::vector<int> PacketExchange::missing() const
{
    std::vector<int> ranks;
    for (const Peer& from : peers_)
        if (!from.here) ranks.push_back(from.rank);
    return ranks;
}

void PacketExchange::receive_all(const char* what)
{
    for (Peer& from : peers_) from.here = false;
    waited_ += participant_.wait_until([this] { return advance(); }, what, [this] { return missing(); });
    for (Peer& from : peers_) ++from.received;
}

void PacketExchange::check(std::size_t peer, const PacketHeader& got, PacketHeader expected) const
{
    expected.field = receive_field_;
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

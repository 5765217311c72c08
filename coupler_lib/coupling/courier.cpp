// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/courier.hpp"

#include "coupler_lib/coupling/participant.hpp"

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

MpiCourier::MpiCourier(Participant& participant, CourierRoute route)
    : participant_(participant), route_(std::move(route)), peers_(route_.peers.size())
{}

void MpiCourier::send(std::size_t peer, std::span<const char> packet)
{
    MPI_Isend(packet.data(), static_cast<int>(packet.size()), MPI_BYTE, route_.peers[peer], tag_of(route_.send_field),
              participant_.coupling_comm(), &peers_[peer].sending);
}

void MpiCourier::await_taken(std::size_t peer)
{
    MPI_Request& sending = peers_[peer].sending;
    if (complete(sending)) return;
    participant_.wait_until([&sending] { return complete(sending); }, "the last packet to be taken",
                            [&] { return std::vector<int>{route_.peers[peer]}; });
}

bool MpiCourier::advance(std::vector<std::vector<char>>& packets)
{
    bool all = true;
    for (std::size_t peer = 0; peer < peers_.size(); ++peer) {
        Peer& from = peers_[peer];
        if (from.here) continue;
        if (from.receiving == MPI_REQUEST_NULL) {
            int arrived = 0;
            MPI_Message message{};
            MPI_Status status{};
            MPI_Improbe(route_.peers[peer], tag_of(route_.receive_field()), participant_.coupling_comm(), &arrived,
                        &message, &status);
            if (arrived) {
                int bytes = 0;
                MPI_Get_count(&status, MPI_BYTE, &bytes);
                packets[peer].resize(static_cast<std::size_t>(bytes));
                MPI_Imrecv(packets[peer].data(), bytes, MPI_BYTE, &message, &from.receiving);
            }
        }
        from.here = from.receiving != MPI_REQUEST_NULL && complete(from.receiving);
        all = all && from.here;
    }
    return all;
}

std::vector<int> MpiCourier::missing() const
{
    std::vector<int> ranks;
    for (std::size_t peer = 0; peer < peers_.size(); ++peer)
        if (!peers_[peer].here) ranks.push_back(route_.peers[peer]);
    return ranks;
}

double MpiCourier::receive_all(const char* what, std::vector<std::vector<char>>& packets)
{
    for (Peer& from : peers_) from.here = false;
    return participant_.wait_until([&] { return advance(packets); }, what, [this] { return missing(); });
}

} // namespace coupler

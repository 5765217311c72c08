// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/courier.hpp"
#include "coupler_lib/coupling/packet.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace coupler {

class Participant;

/// One packet to and one packet from every rank of the partner. Buffers are kept.
class PacketExchange {
public:
    /// \param peers       world ranks of the partner, ascending
    /// \param send_field  what I send; what I receive is the other one
    PacketExchange(Participant& participant, std::vector<int> peers, Field send_field);
    ~PacketExchange();
    PacketExchange(const PacketExchange&) = delete;
    PacketExchange& operator=(const PacketExchange&) = delete;

    std::size_t size() const { return peers_.size(); }
    /// "'solid' (rank 1, pid 4711, host gauss)"
    const std::string& name(std::size_t peer) const { return peers_[peer].name; }

    /// The buffer for the next packet to this peer, empty but for the room of its header. Waits until the last one is out.
    PacketWriter& outgoing(std::size_t peer);
    /// Sends it; sequence and field are filled in.
    void send(std::size_t peer, PacketHeader header);

    /// Waits for one packet of every peer. Throws as Participant::wait_until does. \param what for the message
    void receive_all(const char* what);
    const std::vector<char>& incoming(std::size_t peer) const { return incoming_[peer]; }

    /// Throws base::Error(bad_input), naming both views, unless the packet is what `expected` says: field, sequence (my
    /// own count), step, time, dt and dimension.
    void check(std::size_t peer, const PacketHeader& got, PacketHeader expected) const;

    double wait_seconds() const { return waited_; }
    std::int64_t bytes_sent() const { return bytes_sent_; }
    std::int64_t bytes_received() const { return bytes_received_; }

private:
    struct Peer {
        std::string name;
        PacketWriter outgoing;
        std::int64_t sent = 0;
        std::int64_t received = 0;
    };
    Participant& participant_;
    CourierRoute route_;
    std::unique_ptr<Courier> courier_;
    std::vector<Peer> peers_;
    std::vector<std::vector<char>> incoming_;
    double waited_ = 0;
    std::int64_t bytes_sent_ = 0;
    std::int64_t bytes_received_ = 0;
};

} // namespace coupler

// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/packet.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <mpi.h>
#include <span>
#include <string>
#include <vector>

namespace coupler {

class Participant;

/// Carries packets between this rank and the partner's: over MPI, or from and to a recording. Peers are numbered 0, 1, ...
class Courier {
public:
    virtual ~Courier() = default;

    /// Sends a packet, whose bytes stay as they are until `await_taken`.
    virtual void send(std::size_t peer, std::span<const char> packet) = 0;
    /// Waits until the last packet to this peer is out.
    virtual void await_taken(std::size_t peer) = 0;
    /// One packet of every peer. \param what for messages. \return seconds waited.
    /// \throws base::Error partner_lost when it does not come.
    virtual double receive_all(const char* what, std::vector<std::vector<char>>& packets) = 0;
};

/// Whom a courier serves.
struct CourierRoute {
    std::vector<int> peers; ///< world ranks of the partner, ascending
    Field send_field = Field::load;
    Field receive_field() const { return send_field == Field::load ? Field::motion : Field::load; }
};

/// Makes a courier, or puts another one around that over MPI; see ParticipantSettings::couriers.
using CourierMaker = std::function<std::unique_ptr<Courier>(Participant&, const CourierRoute&)>;

/// Over MPI, directly between the ranks, with bounded waits.
class MpiCourier final : public Courier {
public:
    MpiCourier(Participant& participant, CourierRoute route);

    void send(std::size_t peer, std::span<const char> packet) override;
    void await_taken(std::size_t peer) override;
    double receive_all(const char* what, std::vector<std::vector<char>>& packets) override;

private:
    struct Peer {
        MPI_Request sending = MPI_REQUEST_NULL;
        MPI_Request receiving = MPI_REQUEST_NULL;
        bool here = false;
    };
    bool advance(std::vector<std::vector<char>>& packets);
    std::vector<int> missing() const;

    Participant& participant_;
    CourierRoute route_;
    std::vector<Peer> peers_;
};

} // namespace coupler

// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/courier.hpp"
#include "coupler_lib/recorder/traffic_info.hpp"

namespace coupler {

/// Couriers over MPI that write every packet to traffic_path(path, role, partner, rank): a file for each
/// rank and interface.
/// \param info role, hashes; the rest is filled in.
CourierMaker recording_couriers(const std::string& path, const TrafficInfo& info);

/// How far a replay went, and where what this rank would have sent first differed from what it did send when recorded.
/// Reports (energies, waits) are not compared, all else is, to the bit.
struct ReplayVerdict {
    std::int64_t packets = 0; ///< compared so far
    bool differs = false;
    std::int64_t step = 0; ///< of the first packet that differs
};

/// Couriers that take from the recording what the partner sent then; nobody else is there. The rank's own file must come
/// from as many ranks of its role. `receive_all` throws base::Error(partner_lost) where the recording ends.
CourierMaker replaying_couriers(const std::string& path, std::shared_ptr<ReplayVerdict> verdict);

} // namespace coupler

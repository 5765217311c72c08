// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace coupler {

/// Whose traffic a file holds.
struct TrafficInfo {
    std::string role;                  ///< of the rank that recorded
    int rank = 0, ranks = 1;           ///< among those of its role
    std::string partner;               ///< role on the other side
    int partner_ranks = 1;             ///< how many it has: the peers
    std::string config_hash, git_hash; ///< of the run
};

/// "traffic.h5" of the role "solid", its partner "fluid" and the rank 0: "traffic.solid.fluid.0.h5".
std::string traffic_path(const std::string& path, const std::string& role, const std::string& partner, int rank);

} // namespace coupler

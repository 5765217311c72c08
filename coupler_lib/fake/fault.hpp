// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

namespace coupler {

/// A failure to be acted out, so that the ways a run can end are tested through the programs themselves.
struct FaultConfig {
    std::string kind = "none"; ///< none | throw | nan | kill | silent | leave
    int step = 0;              ///< at which step
    int rank = 0;              ///< of the program's ranks
};

enum class Fault { none, nan, leave };

/// Acts out throw, kill and silent; tells the caller to act out nan and leave.
/// \param step  about to be computed
Fault act_out(const FaultConfig& fault, std::int64_t step, int rank);

} // namespace coupler

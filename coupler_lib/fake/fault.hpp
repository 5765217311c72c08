// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

namespace coupler {

/// A failure to be acted out, so that the ways a run can end are tested through the programs themselves.
struct FaultConfig {
    std::string kind = "none";   ///< none | throw | nan | kill | crash | terminate | stop | silent | leave
    std::string moment = "step"; ///< start | exchange | step | end
    int step = 0;                ///< at which step, for exchange and step
    int rank = 0;                ///< of the program's ranks
};

enum class Fault { none, nan, leave };

/// Acts out what can be done anywhere: an error, signals to itself, silence; tells the caller to act out nan and leave.
/// \param moment  where the program is  \param step  of the exchange, or about to be computed
Fault act_out(const FaultConfig& fault, const std::string& moment, std::int64_t step, int rank);

} // namespace coupler

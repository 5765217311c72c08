// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/introduction.hpp"

#include <mpi.h>
#include <vector>

namespace coupler {

/// What came out of the handshake, the same on every rank that answered.
struct HandshakeResult {
    Verdict verdict;                         ///< code 0: go
    bool complete = true;                    ///< false: some rank never answered, only MPI_Abort can end the run
    std::vector<Introduction> introductions; ///< by world rank
};

/// Every rank brings its introduction to world rank 0, which judges them and sends everybody the verdict; point to
/// point, so that a rank that does not take part is noticed.
///
/// \param mine     fields host, pid and appnum are filled in here
/// \param world    all ranks of the run
/// \param timeout  world rank 0 waits so long for introductions, the others 3 s more for the verdict [s]
/// Collective over `world`; prints nothing.
HandshakeResult shake_hands(Introduction mine, MPI_Comm world, double timeout);

} // namespace coupler

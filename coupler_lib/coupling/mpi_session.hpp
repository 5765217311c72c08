// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace coupler {

/// MPI from start to end of main: a watchdog over MPI_Init (see StartWatchdog), MPI_Finalize on leaving.
class MpiSession {
public:
    /// \param role           own role, for the watchdog's message
    /// \param init_timeout   longest stay in MPI_Init [s]
    /// \param launch_advice  the mpirun line that starts the run, or empty
    MpiSession(int& argc, char**& argv, const std::string& role, double init_timeout,
               const std::string& launch_advice = "");
    ~MpiSession();
    MpiSession(const MpiSession&) = delete;
    MpiSession& operator=(const MpiSession&) = delete;
};

} // namespace coupler

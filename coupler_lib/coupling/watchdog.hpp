// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

namespace coupler {

/// Guards MPI_Init, which blocks for ever when another process of the same mpirun never calls it.
///
/// A thread waits for `timeout` seconds; if `disarm` (or the destructor) has not been called by then it prints what is
/// wrong and ends the process with code 4 (_exit: nothing else can be done from outside MPI_Init), upon which mpirun
/// ends the other processes. Construct it before MPI_Init, disarm it right after.
class StartWatchdog {
public:
    /// \param role           own role, for the message
    /// \param timeout        [s]
    /// \param launch_advice  the mpirun line that starts the run, or empty
    StartWatchdog(const std::string& role, double timeout, const std::string& launch_advice = "");
    ~StartWatchdog();
    StartWatchdog(const StartWatchdog&) = delete;
    StartWatchdog& operator=(const StartWatchdog&) = delete;

    void disarm();

private:
    struct Shared;
    std::unique_ptr<Shared> shared_;
};

/// RIVAGE_HANDSHAKE_TIMEOUT [s] from the environment when it is set to a positive number, else `fallback`.
double handshake_timeout_or(double fallback);

} // namespace coupler

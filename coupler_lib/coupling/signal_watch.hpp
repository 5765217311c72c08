// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace coupler {

/// A rank on the same host, whose life can be looked at.
struct Neighbour {
    int pid = 0;
    std::string name; ///< "'solid' (rank 1, pid 4711, host gauss)"
};

/// Watches for signals while the main thread computes.
///
/// mpirun answers the death of one process by SIGTERM to all others, and about a second later by SIGKILL. A thread of
/// its own therefore looks at once whether a neighbour is gone. If so it prints who vanished, when, and ends this
/// process with code 4; the other survivors on the host are told to stay silent. If all live, SIGTERM and SIGUSR1 are a
/// request to stop. The thread makes no MPI call. A process may have several,
/// one for each run that it takes part in; a request to stop reaches all.
class SignalWatch {
public:
    /// \param own_name  role, for the message
    explicit SignalWatch(const std::string& own_name);
    ~SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

    /// Whom to look at; without neighbours every signal is a request to stop. Survivors speak in the order of
    /// `speaking_order` (world rank), so that one message comes out.
    void set_neighbours(std::vector<Neighbour> neighbours, int speaking_order);
    /// Where the run is, for the message.
    void set_clock(std::int64_t step, double time);

    bool stop_requested() const;
    void request_stop();

    /// Tells the other ranks on this host that this rank prints the message about the end: they stay silent when
    /// SIGTERM reaches them.
    void silence_neighbours() const;

private:
    struct Shared;
    std::unique_ptr<Shared> shared_;
};

/// Whether a process exists and is no zombie.
bool is_alive(int pid);

} // namespace coupler

// SPDX-License-Identifier: MIT
#pragma once
#include <mpi.h>
#include <set>
#include <string>

namespace coupler {

/// Carries the news that a rank failed, or has left in good order, to all other ranks.
///
/// A communicator of its own, so that the news never mixes with other traffic; nothing is posted in advance, so that
/// nothing needs to be taken back at the end. Not collective after construction.
class ErrorChannel {
public:
    /// Collective over `world`, which is duplicated.
    explicit ErrorChannel(MPI_Comm world);
    ~ErrorChannel();
    ErrorChannel(const ErrorChannel&) = delete;
    ErrorChannel& operator=(const ErrorChannel&) = delete;

    /// The failure with the lowest rank that has come in so far.
    struct Failure {
        int from = -1; ///< world rank, -1: none
        int code = 0;  ///< its exit code
        std::string message;
    };

    /// Takes in what has arrived (well below a microsecond when there is nothing).
    void poll();
    const Failure& failure() const { return failure_; }
    bool has_left(int rank) const { return left_.count(rank) > 0; }

    /// Tells every other rank; waits at most `grace` seconds until the messages are out.
    void tell_failure(int code, const std::string& message, double grace);
    void tell_farewell(double grace);

private:
    void tell_all(int tag, const std::string& text, double grace);

    MPI_Comm comm_ = MPI_COMM_NULL;
    Failure failure_;
    std::set<int> left_;
};

} // namespace coupler

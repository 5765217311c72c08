// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/coupling/courier.hpp"
#include "coupler_lib/coupling/introduction.hpp"
#include "coupler_lib/coupling/patience.hpp"
#include "coupler_lib/foundation/check.hpp"
#include "coupler_lib/foundation/communicator.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace coupler {

/// What a rank needs to know to take part in a run; the same on every rank of a role. A solver from outside fills in the
/// roles and leaves the rest: what is empty is not compared.
struct ParticipantSettings {
    MPI_Comm world = MPI_COMM_WORLD;         ///< all ranks of the run
    std::string role;                        ///< by default what the executable is: "fluid", "solid"
    std::vector<std::string> expected_roles; ///< all roles of the run, own one included; empty or {role}: runs alone
    std::string config_file;                 ///< the shared file, for messages
    std::string config_hash;                 ///< of its content with all overrides; must agree on all ranks
    std::string program;                     ///< name of the executable; one for each role
    std::string own_file;                    ///< the role's own configuration, for messages
    std::string own_hash;                    ///< of its content; must agree on all ranks of the role
    std::string version;                     ///< git hash; must agree on all ranks
    std::string libraries;                   ///< with their versions; must agree on all ranks
    std::vector<LaunchSegment> launch;       ///< what starts the whole run, for messages
    std::string failure;                     ///< what went wrong before the handshake (files not readable, ...)
    base::ExitCode failure_code = base::ExitCode::done; ///< `done`: nothing went wrong
    double handshake_timeout = 30;                      ///< [s]
    double silence_timeout = 300;                       ///< longest wait for a partner [s]
    WaitStyle wait = WaitStyle::automatic;
    CourierMaker couriers;               ///< instead of MPI alone: records, or replays; empty: MpiCourier
    std::map<std::string, int> recorded; ///< partners whom recordings stand for, with their ranks; empty: partners live
};

/// An error that all ranks agree on and whose message is out already: the catcher prints nothing.
/// With `orderly` true every rank knows and finalises MPI by itself; otherwise the one that failed calls MPI_Abort.
class AgreedError : public base::Error {
public:
    AgreedError(base::ExitCode code, const std::string& message, bool orderly)
        : base::Error(code, message), orderly_(orderly)
    {}
    [[nodiscard]] bool orderly() const { return orderly_; }

private:
    bool orderly_;
};

/// This rank as a member of a coupled run (or of one that runs alone).
///
/// The constructor is collective over ParticipantSettings::world: roles are found by name through a handshake with a
/// deadline, never by the launch segment. It throws AgreedError (orderly) when the run cannot start: world rank 0 has
/// then printed the one message, and every rank finalises MPI and returns the error's code.
///
/// Afterwards nobody uses that communicator: solvers use `comm()`, the interfaces `coupling_comm()`.
class Participant {
public:
    explicit Participant(const ParticipantSettings& settings);
    ~Participant();
    Participant(const Participant&) = delete;
    Participant& operator=(const Participant&) = delete;

    [[nodiscard]] const std::string& role() const;
    [[nodiscard]] bool coupled() const;                   ///< false when the role runs alone
    [[nodiscard]] const base::Communicator& comm() const; ///< of my role
    [[nodiscard]] MPI_Comm coupling_comm() const;         ///< all ranks of the run, for the interfaces only
    [[nodiscard]] int world_rank() const;
    [[nodiscard]] std::vector<std::string> partners() const;                ///< the other roles
    [[nodiscard]] std::vector<int> ranks_of(const std::string& role) const; ///< world ranks, ascending
    /// World ranks of the partner of an interface. \param role of it; empty: the only one. Throws base::Error(bad_input)
    /// when it is not there, or not the only one.
    [[nodiscard]] std::vector<int> partner_ranks(const std::string& role = "") const;
    [[nodiscard]] const Introduction& introduction(int world_rank) const; ///< role, host, pid of any rank
    [[nodiscard]] std::string name_of(int world_rank) const;              ///< "'solid' (rank 1, pid 4711, host gauss)"

    /// The way for packets of an interface of mine.
    [[nodiscard]] std::unique_ptr<Courier> make_courier(const CourierRoute& route);

    /// Where the run is; used in messages only.
    void set_clock(std::int64_t step, double time);

    /// Looks for errors of other ranks; call once a step. Costs below a microsecond. Throws AgreedError when another
    /// rank failed.
    ///
    /// Signals need no call: when SIGTERM comes because a partner died, a thread of its own names who vanished and
    /// leaves the process with code 4; SIGTERM while all live, or SIGUSR1, sets `stop_requested`.
    void check_signals();

    [[nodiscard]] bool stop_requested() const; ///< this rank was asked to stop; agreed on at the next exchange
    void request_stop();                       ///< as if a signal had come (wall-time limit)

    /// Waits until `done()` is true as ParticipantSettings::wait says, and meanwhile looks for signals and errors.
    ///
    /// \param done      polled; must make MPI progress (MPI_Test, MPI_Improbe)
    /// \param what      what is waited for, e.g. "load 17"
    /// \param pending   world ranks that have not delivered yet; called only for messages and for partners that left
    /// \return seconds waited
    /// Throws base::Error(partner_lost) after the silence timeout, or when a pending rank has left: who waited for
    /// whom, for what, since when. Throws AgreedError when another rank failed.
    double wait_until(const std::function<bool()>& done, const char* what,
                      const std::function<std::vector<int>()>& pending);

    /// Waits until all requests are complete, with the same care. \return seconds waited
    double wait_all(std::vector<MPI_Request>& requests, const char* what, const std::vector<int>& from);

    /// Seconds that this rank has waited for partners so far.
    [[nodiscard]] double wait_seconds() const;

    /// Ends the whole run with this error: tells every other rank, makes sure that one message comes out, waits a short
    /// grace and calls MPI_Abort with the error's code. An AgreedError is not told and not printed again. Returns only
    /// when MPI can be finalised: for an orderly AgreedError, and when this rank is alone in the world.
    void report_failure(const base::Error& error) noexcept;

    /// Regular end: partners that still wait for this rank learn at once that it has left. Call before leaving.
    void finish();

    /// Waits until all others have finished too, so that a partner lost at the very end is noticed and named.
    /// Throws as `wait_until` does.
    void await_farewells();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace coupler

// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/participant.hpp"

#include "coupler_lib/coupling/error_channel.hpp"
#include "coupler_lib/coupling/handshake.hpp"
#include "coupler_lib/coupling/signal_watch.hpp"

#include <algorithm>
#include <set>
#include <unistd.h>

namespace coupler {
namespace {

Introduction introduction_of(const ParticipantSettings& settings)
{
    Introduction mine;
    mine.role = settings.role;
    mine.expected_roles = settings.expected_roles;
    if (mine.expected_roles.empty()) mine.expected_roles = {settings.role};
    mine.config_file = settings.config_file;
    mine.config_hash = settings.config_hash;
    mine.program = settings.program;
    mine.own_file = settings.own_file;
    mine.own_hash = settings.own_hash;
    mine.version = settings.version;
    mine.libraries = settings.libraries;
    mine.launch = settings.launch;
    mine.failure = settings.failure;
    mine.failure_code = static_cast<int>(settings.failure_code);
    return mine;
}

void print_line(const std::string& line)
{
    const std::string text = line + "\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

int rank_in(MPI_Comm world)
{
    int rank = 0;
    MPI_Comm_rank(world, &rank);
    return rank;
}

/// Introductions of all ranks, or AgreedError.
std::vector<Introduction> meet(const ParticipantSettings& settings)
{
    HandshakeResult result = shake_hands(introduction_of(settings), settings.world, settings.handshake_timeout);
    if (result.verdict.code == 0) return std::move(result.introductions);
    if (rank_in(settings.world) == 0 || result.introductions.empty()) print_line("rivage: " + result.verdict.message);
    if (!result.complete) {
        Patience::nap(rank_in(settings.world) == 0 ? 0.1 : 1.0);
        MPI_Abort(settings.world, result.verdict.code);
    }
    throw AgreedError(static_cast<base::ExitCode>(result.verdict.code), result.verdict.message, true);
}

} // namespace

/// A communicator that frees itself while MPI lives.
class OwnedComm {
public:
    OwnedComm() = default;
    ~OwnedComm()
    {
        int finalized = 0;
        MPI_Finalized(&finalized);
        if (!finalized && handle_ != MPI_COMM_NULL) MPI_Comm_free(&handle_);
    }
    OwnedComm(const OwnedComm&) = delete;
    OwnedComm& operator=(const OwnedComm&) = delete;
    MPI_Comm* put() { return &handle_; }
    MPI_Comm get() const { return handle_; }

private:
    MPI_Comm handle_ = MPI_COMM_NULL;
};

struct Participant::Parts {
    explicit Parts(const ParticipantSettings& given)
        : settings(given),
          watch("'" + given.role + "' (rank " + std::to_string(rank_in(given.world)) + ")"),
          introductions(meet(given)),
          errors(given.world)
    {
        world_rank = rank_in(given.world);
        std::set<std::string> names;
        for (const auto& one : introductions) names.insert(one.role);
        roles.assign(names.begin(), names.end());
        const auto colour = std::distance(names.begin(), names.find(settings.role));
        MPI_Comm_split(given.world, static_cast<int>(colour), world_rank, role_comm.put());
        MPI_Comm_dup(given.world, coupling_comm.put());
        comm = base::Communicator(role_comm.get());
        world_size = static_cast<int>(introductions.size());
        for (const auto& [role, ranks] : settings.recorded) add_recorded(role, ranks);
    }

    /// The ranks of a partner that is not here take the numbers behind the world's.
    void add_recorded(const std::string& role, int ranks)
    {
        Introduction one;
        one.role = role;
        one.host = "a recording";
        introductions.insert(introductions.end(), static_cast<std::size_t>(ranks), one);
        roles.push_back(one.role);
        std::sort(roles.begin(), roles.end());
    }

    void throw_failure_of_others() const
    {
        const auto& failure = errors.failure();
        if (failure.from >= 0) throw AgreedError(static_cast<base::ExitCode>(failure.code), failure.message, false);
    }

    ParticipantSettings settings;
    SignalWatch watch;
    std::vector<Introduction> introductions;
    ErrorChannel errors;
    std::vector<std::string> roles;
    int world_rank = 0, world_size = 0;
    OwnedComm role_comm, coupling_comm;
    base::Communicator comm = base::Communicator::self();
    std::int64_t step = -1;
    double time = 0;
    double waited = 0;
};

Participant::Participant(const ParticipantSettings& settings) : parts_(std::make_unique<Parts>(settings))
{
    std::vector<Neighbour> neighbours;
    const std::string& host = introduction(world_rank()).host;
    for (int rank = 0; rank < parts_->world_size; ++rank)
        if (rank != world_rank() && introduction(rank).host == host)
            neighbours.push_back({introduction(rank).pid, name_of(rank)});
    parts_->watch.set_neighbours(std::move(neighbours), world_rank());
}

Participant::~Participant() = default;

const std::string& Participant::role() const { return parts_->settings.role; }
bool Participant::coupled() const { return parts_->roles.size() > 1; }
const base::Communicator& Participant::comm() const { return parts_->comm; }
MPI_Comm Participant::coupling_comm() const { return parts_->coupling_comm.get(); }
int Participant::world_rank() const { return parts_->world_rank; }

std::vector<std::string> Participant::partners() const
{
    std::vector<std::string> others;
    for (const auto& name : parts_->roles)
        if (name != role()) others.push_back(name);
    return others;
}

std::vector<int> Participant::ranks_of(const std::string& role) const
{
    std::vector<int> ranks;
    for (std::size_t rank = 0; rank < parts_->introductions.size(); ++rank)
        if (parts_->introductions[rank].role == role) ranks.push_back(static_cast<int>(rank));
    return ranks;
}

std::vector<int> Participant::partner_ranks(const std::string& wanted) const
{
    const auto others = partners();
    base::require_input(!others.empty(), "an interface needs a partner, but '", role(), "' runs alone");
    base::require_input(!wanted.empty() || others.size() == 1, "'", role(), "' has ", others.size(),
                        " partners: an interface must name its own");
    const auto ranks = ranks_of(wanted.empty() ? others.front() : wanted);
    base::require_input(!ranks.empty(), "no rank of '", wanted, "' takes part in this run");
    return ranks;
}

const Introduction& Participant::introduction(int rank) const
{
    return parts_->introductions.at(static_cast<std::size_t>(rank));
}

std::string Participant::name_of(int rank) const
{
    const Introduction& one = introduction(rank);
    return base::text("'", one.role, "' (rank ", rank, ", pid ", one.pid, ", host ", one.host, ")");
}

std::unique_ptr<Courier> Participant::make_courier(const CourierRoute& route)
{
    if (parts_->settings.couriers) return parts_->settings.couriers(*this, route);
    return std::make_unique<MpiCourier>(*this, route);
}

void Participant::set_clock(std::int64_t step, double time)
{
    parts_->step = step;
    parts_->time = time;
    parts_->watch.set_clock(step, time);
}

void Participant::check_signals()
{
    parts_->errors.poll();
    parts_->throw_failure_of_others();
}

bool Participant::stop_requested() const { return parts_->watch.stop_requested(); }
void Participant::request_stop() { parts_->watch.request_stop(); }

double Participant::wait_until(const std::function<bool()>& done, const char* what,
                               const std::function<std::vector<int>()>& pending)
{
    if (done()) return 0;
    Patience patience(parts_->settings.wait);
    double left_since = -1;
    for (;;) {
        if (done()) {
            const double waited = patience.waited();
            parts_->waited += waited;
            return waited;
        }
        if (!patience.pause()) continue;
        check_signals();
        const double waited = patience.waited();
        if (waited < 1e-3) continue;
        const bool silent = waited > parts_->settings.silence_timeout;
        const auto late = pending();
        const bool gone =
            std::any_of(late.begin(), late.end(), [this](int rank) { return parts_->errors.has_left(rank); });
        if (!gone && !silent) continue;
        if (gone && left_since < 0) left_since = waited; // its last message may still be on the way
        if (!silent && waited - left_since < 0.2) continue;
        std::string names;
        for (const int rank : late) names += (names.empty() ? "" : ", ") + name_of(rank);
        throw base::Error(base::ExitCode::partner_lost,
                          base::text(name_of(world_rank()), " waited ", waited, " s for ", what, " from ", names,
                                     ", since t = ", parts_->time, " s, step ", parts_->step,
                                     gone ? ": the partner has ended its run early"
                                          : ": the partner is silent (coupling.silence_timeout)"));
    }
}

double Participant::wait_seconds() const { return parts_->waited; }

double Participant::wait_all(std::vector<MPI_Request>& requests, const char* what, const std::vector<int>& from)
{
    const auto done = [&requests] {
        int all = 0;
        MPI_Testall(static_cast<int>(requests.size()), requests.data(), &all, MPI_STATUSES_IGNORE);
        return all != 0;
    };
    return wait_until(done, what, [&from] { return from; });
}

void Participant::report_failure(const base::Error& error) noexcept
{
    const int code = static_cast<int>(error.code());
    const auto* agreed = dynamic_cast<const AgreedError*>(&error);
    if (agreed && agreed->orderly()) return;
    parts_->errors.poll();
    if (!agreed && parts_->errors.failure().from < 0) {
        const std::string line = base::text("rivage: ", name_of(world_rank()), ", t = ", parts_->time, " s, step ",
                                            parts_->step, ": ", error.what());
        parts_->watch.silence_neighbours();
        parts_->errors.tell_failure(code, error.what(), 0.1);
        // One message is enough: where several ranks fail at the same time, the lowest one speaks.
        const double until = MPI_Wtime() + (world_rank() == 0 ? 0.0 : 0.3);
        while (MPI_Wtime() < until) {
            parts_->errors.poll();
            Patience::nap(1e-3);
        }
        const int other = parts_->errors.failure().from;
        if (other < 0 || other > world_rank()) print_line(line);
        if (parts_->world_size == 1) return;
        Patience::nap(0.1);
    } else {
        Patience::nap(2.0); // the one that failed ends this process; if it cannot, end it here
    }
    MPI_Abort(parts_->settings.world, code);
}

void Participant::finish() { parts_->errors.tell_farewell(0.1); }

void Participant::await_farewells()
{
    const auto present = [this] {
        parts_->errors.poll();
        std::vector<int> ranks;
        for (int rank = 0; rank < parts_->world_size; ++rank)
            if (rank != world_rank() && !parts_->errors.has_left(rank)) ranks.push_back(rank);
        return ranks;
    };
    const double waited = parts_->waited; // all work is done: no wait that more ranks would shorten
    wait_until([&present] { return present().empty(); }, "the farewell", present);
    parts_->waited = waited;
}

} // namespace coupler

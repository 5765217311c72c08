// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/signal_watch.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <thread>
#include <unistd.h>

namespace coupler {
namespace {

constexpr int silence_magic = 0x71736576;
int silence_signal() { return SIGRTMIN + 5; }

// What a signal handler may touch: lock-free atomics and a pipe.
constexpr int most_watches = 16;
std::atomic<int> wake_pipes[most_watches]; // of each watch; 0: free
std::atomic<bool> silenced{false};
std::atomic<bool> stop_wanted{false};

void wake(int pipe, char what) { [[maybe_unused]] const auto written = write(pipe, &what, 1); }

void on_terminate(int)
{
    const int saved = errno;
    for (const auto& pipe : wake_pipes)
        if (const int open = pipe.load(); open > 0) wake(open, 't');
    errno = saved;
}
void on_stop(int) { stop_wanted = true; }
void on_silence(int, siginfo_t* info, void*)
{
    if (info->si_value.sival_int == silence_magic) silenced = true;
}

void install(int signal, void (*handler)(int))
{
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
}

void install_silence()
{
    struct sigaction action = {};
    action.sa_sigaction = on_silence;
    action.sa_flags = SA_RESTART | SA_SIGINFO;
    sigaction(silence_signal(), &action, nullptr);
}

/// The place of a new watch. The first one takes the signals.
int take_place(int pipe)
{
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    const bool first = std::ranges::all_of(wake_pipes, [](const auto& other) { return other.load() == 0; });
    const auto place = std::ranges::find_if(wake_pipes, [](const auto& other) { return other.load() == 0; });
    base::require_input(place != std::end(wake_pipes), "a process takes part in at most ", most_watches,
                        " runs at a time");
    place->store(pipe);
    if (first) {
        silenced = stop_wanted = false;
        install_silence();
        install(SIGTERM, on_terminate);
        install(SIGUSR1, on_stop);
    }
    return static_cast<int>(place - std::begin(wake_pipes));
}

/// The last one gives the signals back.
void leave_place(int place)
{
    wake_pipes[place] = 0;
    if (std::ranges::any_of(wake_pipes, [](const auto& other) { return other.load() != 0; })) return;
    install(SIGTERM, SIG_DFL);
    install(SIGUSR1, SIG_DFL);
}

void nap_ms(int milliseconds)
{
    const timespec pause{0, milliseconds * 1000000L};
    nanosleep(&pause, nullptr);
}

} // namespace

bool is_alive(int pid)
{
    if (kill(pid, 0) != 0 && errno == ESRCH) return false;
    std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
    std::string line;
    if (!std::getline(file, line)) return kill(pid, 0) == 0;
    const auto bracket = line.rfind(')'); // "pid (name) STATE ..."; the name may hold anything
    const char state = bracket + 2 < line.size() ? line[bracket + 2] : '?';
    return state != 'Z' && state != 'X';
}

struct SignalWatch::Shared {
    std::string own_name;
    std::mutex mutex;
    std::vector<Neighbour> neighbours;
    std::atomic<int> speaking_order{0};
    std::atomic<std::int64_t> step{-1};
    std::atomic<double> time{0};
    int pipe[2] = {-1, -1};
    int place = 0;
    std::thread thread;

    std::vector<Neighbour> known_neighbours()
    {
        const std::lock_guard lock(mutex);
        return neighbours;
    }

    void silence()
    {
        sigval value = {};
        value.sival_int = silence_magic;
        for (const auto& one : known_neighbours()) sigqueue(one.pid, silence_signal(), value);
    }

    /// Prints who vanished and ends the process.
    [[noreturn]] void leave(const std::string& vanished)
    {
        constexpr int code = static_cast<int>(base::ExitCode::partner_lost);
        if (silenced) {
            nap_ms(300); // the one that speaks needs us alive to be sure who vanished
            _exit(code);
        }
        silence();
        const std::string text =
            base::text("rivage: ", own_name, ": the partner ", vanished, " vanished at t = ", time.load(), " s, step ",
                       step.load(), ": it was killed or crashed\n");
        [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
        nap_ms(50);
        _exit(code);
    }

    /// mpirun reaps a killed process just before or after it sends SIGTERM: look for a while.
    void look_after_partners()
    {
        const auto all = known_neighbours();
        nap_ms(std::min(20 * speaking_order.load(), 200));
        for (int attempt = 0; attempt < 30; ++attempt) {
            std::string vanished;
            for (const auto& one : all)
                if (!is_alive(one.pid)) vanished += (vanished.empty() ? "" : " and ") + one.name;
            if (!vanished.empty() || silenced) leave(vanished);
            nap_ms(10);
        }
        stop_wanted = true;
    }

    void run()
    {
        for (;;) {
            char what = 0;
            const auto got = read(pipe[0], &what, 1);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0 || what == 'q') return;
            look_after_partners();
        }
    }
};

SignalWatch::SignalWatch(const std::string& own_name) : shared_(std::make_unique<Shared>())
{
    shared_->own_name = own_name;
    base::require(pipe2(shared_->pipe, O_CLOEXEC) == 0, base::ExitCode::bad_input,
                  "no pipe for the signal watch: too many open files?");
    shared_->place = take_place(shared_->pipe[1]);
    shared_->thread = std::thread([shared = shared_.get()] { shared->run(); });
}

SignalWatch::~SignalWatch()
{
    leave_place(shared_->place);
    wake(shared_->pipe[1], 'q');
    shared_->thread.join();
    close(shared_->pipe[0]);
    close(shared_->pipe[1]);
}

void SignalWatch::set_neighbours(std::vector<Neighbour> neighbours, int speaking_order)
{
    const std::lock_guard lock(shared_->mutex);
    shared_->neighbours = std::move(neighbours);
    shared_->speaking_order = speaking_order;
}

void SignalWatch::set_clock(std::int64_t step, double time)
{
    shared_->step = step;
    shared_->time = time;
}

bool SignalWatch::stop_requested() const { return stop_wanted; }
void SignalWatch::request_stop() { stop_wanted = true; }
void SignalWatch::silence_neighbours() const { shared_->silence(); }

} // namespace coupler

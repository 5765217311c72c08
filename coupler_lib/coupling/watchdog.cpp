// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/watchdog.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <unistd.h>

namespace coupler {
namespace {

std::string environment(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

std::string alarm_text(const std::string& role, double timeout, const std::string& launch_advice)
{
    const std::string size = environment("OMPI_COMM_WORLD_SIZE");
    std::string text = base::text("rivage: '", role, "' has waited ", timeout, " s in MPI_Init: ");
    text += size.empty() ? "not all processes of this launch have called it.\n"
                         : "of the " + size + " processes that mpirun started, at least one has not called it.\n";
    text += "  Check that every segment of the command starts a program of Rivage, that none of them crashed or waits\n"
            "  for something else, and that all nodes use the same Open MPI.\n";
    if (!launch_advice.empty()) text += "  The right command:\n    " + launch_advice + "\n";
    return text;
}

/// Ranks fire one after the other, so that the first one's message is the only one: its exit ends the others.
double stagger()
{
    const int rank = std::atoi(environment("OMPI_COMM_WORLD_RANK").c_str());
    return std::clamp(2 * rank, 0, 4); // [s]; mpirun takes a good second to end the others
}

} // namespace

struct StartWatchdog::Shared {
    std::mutex mutex;
    std::condition_variable changed;
    bool disarmed = false;
    std::thread thread;
};

StartWatchdog::StartWatchdog(const std::string& role, double timeout, const std::string& launch_advice)
    : shared_(std::make_unique<Shared>())
{
    const std::string text = alarm_text(role, timeout, launch_advice);
    const std::chrono::duration<double> patience(timeout + stagger());
    shared_->thread = std::thread([shared = shared_.get(), text, patience] {
        std::unique_lock lock(shared->mutex);
        if (shared->changed.wait_for(lock, patience, [shared] { return shared->disarmed; })) return;
        [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
        _exit(static_cast<int>(base::ExitCode::partner_lost));
    });
}

StartWatchdog::~StartWatchdog() { disarm(); }

void StartWatchdog::disarm()
{
    if (!shared_->thread.joinable()) return;
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->disarmed = true;
    }
    shared_->changed.notify_all();
    shared_->thread.join();
}

double handshake_timeout_or(double fallback)
{
    const double value = std::atof(environment("RIVAGE_HANDSHAKE_TIMEOUT").c_str());
    return value > 0 ? value : fallback;
}

} // namespace coupler

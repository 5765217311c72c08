// SPDX-License-Identifier: MIT
#include "coupler_lib/base/progress.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

namespace base {
namespace {

std::string duration(double seconds)
{
    if (!std::isfinite(seconds)) return "?";
    const auto whole = static_cast<long>(seconds + 0.5);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02d} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02d} min", whole / 3600, whole / 60 % 60);
}

/// Is somebody watching? mpirun gives every program a terminal of its own, so there its own output decides.
bool watched()
{
    if (isatty(STDOUT_FILENO) != 1) return false;
    if (!std::getenv("OMPI_COMM_WORLD_SIZE")) return true;
    std::error_code error;
    const auto launcher = std::filesystem::read_symlink(fmt::format("/proc/{}/fd/1", getppid()), error).string();
    return !error && (launcher.rfind("/dev/pts/", 0) == 0 || launcher.rfind("/dev/tty", 0) == 0);
}

}  // namespace

Progress::Progress(const Log& log, double start_time, double end_time)
    : log_(&log), start_time_(start_time), end_time_(end_time), terminal_(watched())
{
}

std::string Progress::line(double time, std::int64_t step, double dt) const
{
    const double elapsed = watch_.seconds();
    const double share = (time - start_time_) / (end_time_ - start_time_);
    return fmt::format("t = {:.4g} s of {:g} s ({:.0f} %), step {}, dt = {:.3g} s, {:.0f} steps/s, {} left", time, end_time_,
                       100 * share, step, dt, static_cast<double>(step - first_step_) / elapsed,
                       duration(elapsed * (1 - share) / share));
}

void Progress::update(double time, std::int64_t step, double dt)
{
    if (!log_->active()) return;
    if (first_step_ < 0) first_step_ = step - 1;
    const double now = watch_.seconds();
    if (now - last_shown_ < (terminal_ ? 0.5 : 5.0)) return;
    last_shown_ = now;
    const std::string shown = line(time, step, dt);
    if (!terminal_) return log_->info(shown);
    std::printf("\r%-*s", static_cast<int>(shown_width_), shown.c_str());
    std::fflush(stdout);
    shown_width_ = shown.size();
}

void Progress::finish()
{
    if (terminal_ && shown_width_ > 0) std::printf("\n");
    shown_width_ = 0;
}

}  // namespace base

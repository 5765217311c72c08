// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <ctime>
#include <sched.h>

namespace coupler {

/// How a rank waits: it spins for some ten microseconds, then gives its core away (sched_yield) for a millisecond, then
/// sleeps 50 us at a time, so that ranks which share cores do not starve each other.
class Patience {
public:
    /// One turn of waiting. \return true when this is a good moment to look for other news (errors, time-outs)
    bool pause()
    {
        ++turns_;
        if (turns_ < spinning_turns_) return turns_ % 64 == 0;
        const double so_far = waited();
        if (so_far < yielding_time_)
            sched_yield();
        else
            nap(50e-6);
        return true;
    }

    /// Seconds since the wait began.
    double waited() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    /// Sleeps without looking at anything. \param seconds [s]
    static void nap(double seconds)
    {
        const auto whole = static_cast<time_t>(seconds);
        const timespec pause{whole, static_cast<long>((seconds - static_cast<double>(whole)) * 1e9)};
        nanosleep(&pause, nullptr);
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr int spinning_turns_ = 200;
    static constexpr double yielding_time_ = 1e-3; // [s]
    Clock::time_point start_ = Clock::now();
    int turns_ = 0;
};

} // namespace coupler

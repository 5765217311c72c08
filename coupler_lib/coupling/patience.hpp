// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <ctime>
#include <limits>
#include <sched.h>

namespace coupler {

/// How a rank waits for a partner.
enum class WaitStyle {
    automatic, ///< spin, then yield, then sleep
    spin,      ///< never give the core away: the least latency, for ranks with cores of their own
    yield      ///< give the core away at once: for ranks that share cores
};

/// One wait: it spins for some ten microseconds, then gives its core away (sched_yield) for a tenth of a millisecond, then
/// sleeps 50 us at a time, so that ranks which share cores do not starve each other.
class Patience {
public:
    explicit Patience(WaitStyle style = WaitStyle::automatic)
    {
        if (style == WaitStyle::spin) spinning_turns_ = std::numeric_limits<std::int64_t>::max();
        if (style == WaitStyle::yield) spinning_turns_ = 0;
    }

    /// One turn of waiting. \return true when this is a good moment to look for other news (errors, time-outs)
    bool pause()
    {
        ++turns_;
        if (turns_ < spinning_turns_) return turns_ % 64 == 0;
        if (waited() < yielding_time_)
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
    static constexpr double yielding_time_ = 1e-4; // [s]
    Clock::time_point start_ = Clock::now();
    std::int64_t turns_ = 0;
    std::int64_t spinning_turns_ = 200;
};

} // namespace coupler

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
    automatic, ///< spin, then yield, then sleep; spins longer where every rank on the host has a core of its own
    spin,      ///< never give the core away: the least latency, for ranks with cores of their own
    yield      ///< give the core away at once: for ranks that share cores
};

/// One wait: it spins, then gives its core away (sched_yield), then sleeps 50 us at a time, so that ranks which share
/// cores do not starve each other. \param crowded in the constructor: there are more ranks than cores on this host
class Patience {
public:
    explicit Patience(WaitStyle style = WaitStyle::automatic, bool crowded = true)
    {
        if (style == WaitStyle::yield) spinning_turns_ = 0;
        if (style == WaitStyle::spin) spinning_time_ = std::numeric_limits<double>::infinity();
        if (style == WaitStyle::automatic && !crowded) spinning_time_ = 1e-3;
    }

    /// One turn of waiting. \return true when this is a good moment to look for other news (errors, time-outs)
    bool pause()
    {
        ++turns_;
        if (turns_ < spinning_turns_) return turns_ % 64 == 0;
        if (spinning_time_ > 0 && turns_ % 64 != 0) return false;
        const double so_far = waited();
        if (so_far < spinning_time_) return true;
        spinning_time_ = 0;
        if (so_far < sleeping_from_)
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
    static constexpr double sleeping_from_ = 2e-3; // [s]
    Clock::time_point start_ = Clock::now();
    std::int64_t turns_ = 0;
    int spinning_turns_ = 200; ///< before the clock is looked at
    double spinning_time_ = 0; ///< [s]
};

} // namespace coupler

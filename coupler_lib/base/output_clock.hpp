// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

namespace base {

/// Says at which steps something is written: the first one, then the first at or after each multiple of an interval.
/// Steps are not cut for it. Participants that see the same times make the same choice.
class OutputClock {
public:
    /// What an interval of zero asks for.
    enum class Zero { every_step, never };

    /// \param interval [s], not negative
    OutputClock(double interval, Zero zero) : interval_(interval), zero_(zero) {}

    /// To be asked once for every step, with rising times. \param time [s]
    bool due(double time)
    {
        const bool first = !started_;
        if (first) begin(time);
        if (interval_ == 0) return first || zero_ == Zero::every_step;
        const double count = std::floor((time - origin_) / interval_ + tolerance_);
        if (!first && count <= last_) return false;
        last_ = count;
        return true;
    }

private:
    static constexpr double tolerance_ = 1e-9; // of an interval: a time short of it by round-off counts

    void begin(double time)
    {
        started_ = true;
        origin_ = interval_ > 0 ? interval_ * std::floor(time / interval_ + tolerance_) : time;
    }

    double interval_;
    Zero zero_;
    bool started_ = false;
    double origin_ = 0, last_ = 0;
};

} // namespace base

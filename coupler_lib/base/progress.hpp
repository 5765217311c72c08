// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/log.hpp"
#include "coupler_lib/base/timer.hpp"

#include <cstdint>

namespace base {

/// How far a run is: physical time, step, dt, steps a second, time left. On a terminal one line that renews itself
/// twice a second, otherwise a line every five seconds.
class Progress {
public:
    Progress(const Log& log, double start_time, double end_time);

    /// To be called after every step by rank 0; cheap.
    void update(double time, std::int64_t step, double dt);
    /// Ends the line.
    void finish();

private:
    std::string line(double time, std::int64_t step, double dt) const;

    const Log* log_;
    double start_time_, end_time_;
    bool terminal_;
    Stopwatch watch_;
    double last_shown_ = 0;
    std::int64_t first_step_ = -1;
    std::size_t shown_width_ = 0;
};

}  // namespace base

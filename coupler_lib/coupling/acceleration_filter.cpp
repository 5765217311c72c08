// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/acceleration_filter.hpp"

#include <algorithm>

namespace coupler {

void AccelerationFilter::apply(double time, SurfaceMotion& motion)
{
    if (steps_ <= 0) return;
    while (!states_.empty() && states_.back().time >= time) states_.pop_back();
    while (states_.size() > static_cast<std::size_t>(steps_)) states_.pop_front();
    if (states_.empty()) {
        std::fill(motion.acceleration.begin(), motion.acceleration.end(), 0.0);
    } else {
        const State& oldest = states_.front();
        const double span = time - oldest.time;
        for (std::size_t k = 0; k < motion.acceleration.size(); ++k)
            motion.acceleration[k] = (motion.velocity[k] - oldest.velocity[k]) / span;
    }
    states_.push_back({time, motion.velocity});
}

} // namespace coupler

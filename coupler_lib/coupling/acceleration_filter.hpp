// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/surface.hpp"

#include <deque>
#include <vector>

namespace coupler {

/// The acceleration that the fluid moves its walls with: the solid's mean over its last k steps,
///
///     a = (v_n - v_{n-k}) / (t_n - t_{n-k})   [m/s^2]
///
/// (as far back as the run reaches), or the nodal acceleration as it is. Nodal values are noisy at contact and feed the
/// lag of the parallel exchange; k = 1 is the mean of the last step, larger k a low-pass.
class AccelerationFilter {
public:
    /// \param steps  k; 0: leave the nodal acceleration alone
    explicit AccelerationFilter(int steps) : steps_(steps) {}

    /// Replaces `motion.acceleration`; call once for every converged state, in the order of time. Without a step behind
    /// it the mean is zero: the nodal acceleration of the start does not know yet what the fluid answers.
    void apply(double time, SurfaceMotion& motion);

private:
    struct State {
        double time;
        std::vector<double> velocity;
    };
    int steps_;
    std::deque<State> states_; ///< oldest first, at most k
};

} // namespace coupler

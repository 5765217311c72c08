// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace sph {

/// One evaluation of the rates k_s within a step from y_n to y_n+1.
struct Stage {
    double time = 0;   ///< c_s: where in the step the rates are evaluated, over dt
    double weight = 0; ///< b_s: share of these rates in the whole step
    double next = 0;   ///< a_(s+1,s): how far the next stage's state lies along these rates, over dt
};

/// Explicit Runge-Kutta method whose stages use only the rates just before them:
///
///     y_s+1 = y_n + a_(s+1,s) dt k_s,     y_n+1 = y_n + dt sum b_s k_s
///
/// Whatever else is integrated over the step (work, impulses, dissipations) takes the same weights b_s, else balances
/// do not close.
class RungeKutta {
public:
    /// \param name "rk2" (midpoint, the default: clean up to dt = 0.7 h/c), "rk3" (Heun, 0.9), "rk4" (classical, 1.0).
    /// Throws Error(bad_input) for another name.
    explicit RungeKutta(const std::string& name = "rk2");

    const std::vector<Stage>& stages() const { return stages_; }

private:
    std::vector<Stage> stages_;
};

} // namespace sph

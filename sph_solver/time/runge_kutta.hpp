// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace sph {

/// What an evaluation reconstructs with.
enum class Slopes {
    made, ///< gradients and pair areas of the present state
    kept  ///< those of the evaluation before
};

/// One evaluation of the rates k_s within a step from y_n to y_n+1.
struct Stage {
    double time = 0;              ///< c_s: where in the step the rates are evaluated, over dt
    double weight = 0;            ///< b_s: share of these rates in the whole step
    double next = 0;              ///< a_(s+1,s): how far the next stage's state lies along these rates, over dt
    Slopes slopes = Slopes::made; ///< of this evaluation; of the first always made
};

/// Explicit Runge-Kutta method whose stages use only the rates just before them:
///
///     y_s+1 = y_n + a_(s+1,s) dt k_s,     y_n+1 = y_n + dt sum b_s k_s
///
/// Whatever else is integrated over the step (work, impulses, dissipations) takes the same weights b_s, else balances
/// do not close.
///
/// The stages of "hybrid3" are chosen for the pair fluxes, whose fastest modes are damped and hardly oscillate: their
/// eigenvalues reach far along the negative axis, where three stages of second order can go three times as far as two.
/// Slopes kept through the step cost no order (what they are late by, c dt, multiplies what they correct, dx) and lengthen
/// the step that is stable (docs/theory/fluid.md). Stages that skip a part of the residual: Jameson 1985; stages for
/// smoothing: van Leer, Tai and Powell 1989.
class RungeKutta {
public:
    /// \param name "rk2" (midpoint, the default: clean up to dt = 0.7 h/c), "rk3" (Heun, 0.9), "rk4" (classical, 1.0);
    /// "hybrid3" (midpoint with slopes kept, 1.6). Throws Error(bad_input) for another name.
    explicit RungeKutta(const std::string& name = "rk2");

    const std::vector<Stage>& stages() const { return stages_; }

private:
    std::vector<Stage> stages_;
};

} // namespace sph

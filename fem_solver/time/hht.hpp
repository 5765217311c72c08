// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/motion.hpp"

namespace fem {

/// The HHT-alpha scheme in its full form, g = f_int + C v - f_ext
/// (H. Hilber, T. Hughes, R. Taylor, Earthquake Eng. Struct. Dyn. 5 (1977) 283):
///
///     M a_1 + (1 + alpha) g_1 - alpha g_0 = 0,      beta = (1 - alpha)^2 / 4,   gamma = 1/2 - alpha
///     u_1 = u_0 + dt v_0 + dt^2 [(1/2 - beta) a_0 + beta a_1]
///     v_1 = v_0 + dt [(1 - gamma) a_0 + gamma a_1]
///
/// alpha in [-1/3, 0]; 0 is the average acceleration scheme without dissipation, -0.05 damps a little, mostly high
/// frequencies.
class Hht {
public:
    explicit Hht(double alpha) : alpha_(alpha) {}

    double alpha() const { return alpha_; }
    double beta() const { return 0.25 * (1 - alpha_) * (1 - alpha_); }
    double gamma() const { return 0.5 - alpha_; }

    /// da_1/du_1 [1/s^2] and dv_1/du_1 [1/s].
    double acceleration_slope(double dt) const { return 1 / (beta() * dt * dt); }
    double velocity_slope(double dt) const { return gamma() / (beta() * dt); }

    /// From the converged motion at the start of the step to a first iterate with the same acceleration.
    void predict(Motion& motion, double dt) const;
    /// The same with the same displacement; acceleration and velocity are those that belong to it.
    void predict_still(Motion& motion, double dt) const;
    /// Adds `scale` times a displacement correction, and what it brings to velocity and acceleration.
    void correct(Motion& motion, const Eigen::VectorXd& correction, double scale, double dt) const;

private:
    double alpha_;
};

} // namespace fem

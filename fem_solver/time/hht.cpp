// SPDX-License-Identifier: MIT
#include "fem_solver/time/hht.hpp"

namespace fem {

void Hht::predict(Motion& motion, double dt) const
{
    motion.displacement += dt * motion.velocity + 0.5 * dt * dt * motion.acceleration;
    motion.velocity += dt * motion.acceleration;
}

void Hht::predict_still(Motion& motion, double dt) const
{
    const Eigen::VectorXd a0 = motion.acceleration;
    motion.acceleration = -(motion.velocity / dt + (0.5 - beta()) * a0) / beta();
    motion.velocity += dt * ((1 - gamma()) * a0 + gamma() * motion.acceleration);
}

void Hht::correct(Motion& motion, const Eigen::VectorXd& correction, double scale, double dt) const
{
    motion.displacement += scale * correction;
    motion.velocity += scale * velocity_slope(dt) * correction;
    motion.acceleration += scale * acceleration_slope(dt) * correction;
}

} // namespace fem

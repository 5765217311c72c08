// SPDX-License-Identifier: MIT
#include "fem_solver/contact/contact_law.hpp"

namespace fem {

ContactTraction contact_traction(const base::GroundPoint& ground, const Multipliers& multipliers,
                                 const Eigen::Vector3d& moved, const ContactConstants& constants)
{
    ContactTraction traction;
    const Eigen::Vector3d& n = ground.normal;
    const Eigen::Matrix3d& dn = ground.normal_slope;
    traction.pressure = multipliers.pressure - constants.normal_penalty * ground.gap;
    traction.touches = traction.pressure >= 0;
    if (!traction.touches) {
        traction.pressure = 0;
        return traction;
    }
    const double p = traction.pressure;
    const Eigen::RowVector3d dp = -constants.normal_penalty * ground.gap_slope.transpose();
    traction.slope = n * dp + p * dn;
    if (constants.friction == 0) return traction;

    const Eigen::Matrix3d projector = Eigen::Matrix3d::Identity() - n * n.transpose();
    const Eigen::Vector3d a = multipliers.traction - constants.tangential_penalty * moved;
    const Eigen::Vector3d trial = projector * a;
    const Eigen::Matrix3d trial_slope =
        -constants.tangential_penalty * projector - n.dot(a) * dn - n * (a.transpose() * dn);
    const double limit = constants.friction * p, size = trial.norm();
    traction.sticks = size <= limit;
    if (traction.sticks) {
        traction.friction = trial;
        traction.slope += trial_slope;
        return traction;
    }
    const Eigen::Vector3d along = trial / size;
    traction.friction = limit * along;
    traction.slope +=
        constants.friction * along * dp + limit / size * (trial_slope - along * (along.transpose() * trial_slope));
    return traction;
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/dofs/rigid_drive.hpp"

#include <cmath>
#include <limits>

namespace fem {

RigidDrive::RigidDrive(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
                       std::array<base::TimeFunction, 3> translation, base::TimeFunction angle)
    : centre_(centre), translation_(std::move(translation)), angle_(std::move(angle))
{
    const Eigen::Vector3d w = axis.normalized();
    cross_ << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
    pose_.time = std::numeric_limits<double>::quiet_NaN();
}

const RigidDrive::Pose& RigidDrive::at(double time) const
{
    if (pose_.time == time) return pose_;
    for (int k = 0; k < 3; ++k) {
        const base::TimeValue d = translation_[k](time);
        pose_.shift[k] = d.value;
        pose_.velocity[k] = d.rate;
        pose_.acceleration[k] = d.acceleration;
    }
    const base::TimeValue theta = angle_(time);
    const double s = std::sin(theta.value), half = std::sin(0.5 * theta.value), c = 1 - 2 * half * half;
    const Eigen::Matrix3d square = cross_ * cross_, slope = c * cross_ + s * square, bend = c * square - s * cross_;
    pose_.turned = s * cross_ + 2 * half * half * square;
    pose_.turned_1 = theta.rate * slope;
    pose_.turned_2 = theta.acceleration * slope + theta.rate * theta.rate * bend;
    pose_.time = time;
    return pose_;
}

base::TimeValue RigidDrive::displacement(const Eigen::Vector3d& reference, int component, double time) const
{
    const Pose& pose = at(time);
    const Eigen::Vector3d arm = reference - centre_;
    return {pose.shift[component] + pose.turned.row(component).dot(arm),
            pose.velocity[component] + pose.turned_1.row(component).dot(arm),
            pose.acceleration[component] + pose.turned_2.row(component).dot(arm)};
}

} // namespace fem

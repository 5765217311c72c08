// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/time_function.hpp"

#include <Eigen/Core>

#include <array>

namespace fem {

/// A rigid motion over time: a shift d(t) of the centre c and a turn by the angle theta(t) about a fixed axis through it.
///
///     u = d + (R - I) r,   r = X - c,   R = I + sin(theta) W + (1 - cos(theta)) W^2,   W r = axis x r
///     v = d' + theta' R_1 r,   a = d'' + (theta'' R_1 + theta'^2 R_2) r,   R_1 = dR/dtheta, R_2 = d2R/dtheta2
///
/// Velocity and acceleration belong to the displacement exactly, so far as d and theta give their derivatives.
class RigidDrive {
public:
    /// \param centre in the reference state [m]. \param axis of the turn, of any length but zero. In 2D centre[2] = 0 and
    /// the axis is z. \param translation, angle over time [m], [rad].
    RigidDrive(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
               std::array<base::TimeFunction, 3> translation, base::TimeFunction angle);

    /// Displacement of a point of the body along an axis (0, 1, 2), with its derivatives in time.
    base::TimeValue displacement(const Eigen::Vector3d& reference, int component, double time) const;
    /// Where the centre is [m].
    Eigen::Vector3d centre(double time) const { return centre_ + at(time).shift; }

private:
    /// What all points share at one instant.
    struct Pose {
        double time;
        Eigen::Vector3d shift, velocity, acceleration;
        Eigen::Matrix3d turned, turned_1, turned_2; // R - I and its first and second derivatives in time
    };
    const Pose& at(double time) const;

    Eigen::Vector3d centre_;
    Eigen::Matrix3d cross_; // W
    std::array<base::TimeFunction, 3> translation_;
    base::TimeFunction angle_;
    mutable Pose pose_; // of the instant last asked for
};

} // namespace fem

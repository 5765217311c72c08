// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fem {

/// Outward normal times area per unit of the face's reference coordinates, n dA/dxi.
///
///     2D: (t_y, -t_x)      3D: t_1 x t_2
///
/// \param tangents D x (D-1), columns dx/dxi_k [m]; the face runs with the body on the left (2D) or
///                 counterclockwise seen from outside (3D).
inline Eigen::Vector2d face_normal(const Eigen::Vector2d& tangents) { return {tangents[1], -tangents[0]}; }
inline Eigen::Vector3d face_normal(const Eigen::Matrix<double, 3, 2>& tangents)
{
    return tangents.col(0).cross(tangents.col(1));
}

/// Derivative of face_normal for a node's displacement: matrix S with d(n dA) = S d(x_a).
///
/// \param tangents as in face_normal. \param gradient dN_a/dxi_k of that node.
inline Eigen::Matrix2d face_normal_derivative(const Eigen::Vector2d&, const Eigen::Matrix<double, 1, 1>& gradient)
{
    Eigen::Matrix2d s;
    s << 0, gradient[0], -gradient[0], 0;
    return s;
}
inline Eigen::Matrix3d face_normal_derivative(const Eigen::Matrix<double, 3, 2>& tangents,
                                              const Eigen::Vector2d& gradient)
{
    const Eigen::Vector3d w = gradient[1] * tangents.col(0) - gradient[0] * tangents.col(1);
    Eigen::Matrix3d s; // d(t1 x t2) = dx N_1 x t2 + t1 x dx N_2 = (N_2 t1 - N_1 t2) x dx
    s << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
    return s;
}

} // namespace fem

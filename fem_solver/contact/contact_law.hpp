// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/ground.hpp"

#include <Eigen/Core>

namespace fem {

/// Constants of a contact.
struct ContactConstants {
    double normal_penalty = 0;     ///< eps_n [Pa/m]
    double tangential_penalty = 0; ///< eps_t [Pa/m]
    double friction = 0;           ///< mu [-]
};

/// Multipliers of one point: what its tractions are known to be.
struct Multipliers {
    double pressure = 0;                                ///< lambda_n [Pa], per reference area
    Eigen::Vector3d traction = Eigen::Vector3d::Zero(); ///< lambda_t [Pa]
};

/// Tractions at one point per reference area, and their change as the point moves.
struct ContactTraction {
    double pressure = 0;                                ///< p >= 0 [Pa]
    Eigen::Vector3d friction = Eigen::Vector3d::Zero(); ///< tau, tangential [Pa]
    Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();    ///< d(p n + tau)/dx [Pa/m]
    bool touches = false;                               ///< p > 0, or about to be: gap and multiplier are exactly zero
    bool sticks = true;
};

/// Augmented Lagrangian contact with Coulomb friction at one point (J. C. Simo, T. A. Laursen, Computers & Structures 42
/// (1992) 97-116). With the gap g, the normal n, P = I - n n^T and the way d that the point has moved against the ground
/// since the last accepted step:
///
///     p = max(0, lambda_n - eps_n g)
///     tau' = P (lambda_t - eps_t d),      tau = tau'               where |tau'| <= mu p (stick)
///                                         tau = mu p tau'/|tau'|   else (slip)
///
/// Outside contact there is no friction either. A point that just touches (p = 0 and gap = 0) already has its stiffness, so
/// that a body may be put down on the ground.
ContactTraction contact_traction(const base::GroundPoint& ground, const Multipliers& multipliers,
                                 const Eigen::Vector3d& moved, const ContactConstants& constants);

} // namespace fem

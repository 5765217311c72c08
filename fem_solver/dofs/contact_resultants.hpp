// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace fem {

/// What a contact does as a whole.
struct ContactResultants {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();   ///< force of the pressures on the body [N] (2D: N/m)
    Eigen::Vector3d friction = Eigen::Vector3d::Zero(); ///< force of friction on the body
    double area = 0;                                    ///< present area in contact [m^2] (2D: m)
    double pressure = 0;                                ///< largest, per present area [Pa]
    double penetration = 0;                             ///< deepest [m]
};

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace fem {

/// Motion of all nodes at one time; entry `node * dimension + component` of each vector.
struct Motion {
    Eigen::VectorXd displacement; ///< [m]
    Eigen::VectorXd velocity;     ///< [m/s]
    Eigen::VectorXd acceleration; ///< [m/s^2]

    static Motion at_rest(Eigen::Index dofs)
    {
        return {Eigen::VectorXd::Zero(dofs), Eigen::VectorXd::Zero(dofs), Eigen::VectorXd::Zero(dofs)};
    }
};

} // namespace fem

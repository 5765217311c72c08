// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <numbers>
#include <vector>

namespace fem {

/// A natural vibration of the body about its present state.
struct Mode {
    /// w [rad/s]; zero for a rigid motion, -sqrt(-w^2) where w^2 < 0: the state is unstable
    double angular_frequency = 0;
    Eigen::VectorXd shape; ///< phi, with phi . M phi = 1 [kg^-1/2] (2D: (kg/m)^-1/2); largest entry positive
    double residual = 0;   ///< max |K phi - w^2 M phi| over max (|K| |phi|)
    /// Participating mass (phi . M e)^2 along each axis, e the unit translation [kg] (2D: kg/m): over all modes they sum up
    /// to the mass that is not held.
    std::vector<double> masses;

    double frequency() const { return angular_frequency / (2 * std::numbers::pi); } ///< [Hz]
};

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/solve/newton.hpp"

namespace fem {

bool NewtonMonitor::converged(const Eigen::VectorXd& residual, double force, double round_off)
{
    const double largest = residual.cwiseAbs().maxCoeff(&worst_);
    residuals_.push_back(largest);
    return largest <= settings_.tolerance * force + round_off; // false for NaN
}

bool NewtonMonitor::slow() const
{
    const std::size_t n = residuals_.size();
    return n >= 2 && !(residuals_[n - 1] <= settings_.contraction * residuals_[n - 2]);
}

} // namespace fem

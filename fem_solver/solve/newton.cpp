// SPDX-License-Identifier: MIT
#include "fem_solver/solve/newton.hpp"

#include <limits>

namespace fem {

bool NewtonMonitor::converged(const Eigen::VectorXd& residual, double force, double round_off)
{
    const DofMap::Largest largest = dofs_->find_largest(residual);
    worst_ = largest.entry;
    residuals_.push_back(largest.value);
    return largest.value <= settings_.tolerance * force + round_off; // false for what is not a number
}

bool NewtonMonitor::broken() const { return residuals_.back() > std::numeric_limits<double>::max(); }

bool NewtonMonitor::slow() const
{
    const std::size_t n = residuals_.size();
    return n >= 2 && !(residuals_[n - 1] <= settings_.contraction * residuals_[n - 2]);
}

} // namespace fem

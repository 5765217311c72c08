// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/dof_map.hpp"

#include <vector>

namespace fem {

/// When Newton's iteration has converged, when it needs a new factorisation, and when it has failed.
struct NewtonSettings {
    double tolerance = 1e-9;  ///< largest residual over the largest nodal force present
    int max_iterations = 25;  ///< in one step
    double contraction = 0.1; ///< a kept factorisation is renewed when the residual falls by less than this factor
};

/// Watches the residuals of one step.
///
/// Converged when max |r_i| <= tolerance * force + round_off, with force the largest nodal force (internal, external or
/// inertial) of the iterate. The residual ratio of successive iterations tells how good a kept factorisation still is.
class NewtonMonitor {
public:
    /// \param dofs outlives the monitor.
    NewtonMonitor(const NewtonSettings& settings, const DofMap& dofs) : settings_(settings), dofs_(&dofs) {}

    void start() { residuals_.clear(); }
    /// Notes the residual of the present iterate. Collective. \param force, round_off see above [N].
    bool converged(const Eigen::VectorXd& residual, double force, double round_off);
    /// The last correction reduced the residual by too little.
    bool slow() const;
    /// The last residual holds what is no finite number, at entry worst().
    bool broken() const;
    bool exhausted() const { return static_cast<int>(residuals_.size()) > settings_.max_iterations; }
    /// Entry of the largest residual, for the message of a failure; -1 on ranks that do not hold it.
    Eigen::Index worst() const { return worst_; }
    /// Largest residual of each iterate so far [N].
    const std::vector<double>& residuals() const { return residuals_; }

private:
    NewtonSettings settings_;
    const DofMap* dofs_;
    std::vector<double> residuals_;
    Eigen::Index worst_ = -1;
};

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/solve/linear_solver.hpp"

#include <Eigen/SparseLU>

namespace fem {

/// Eigen's supernodal sparse LU with a column ordering against fill, on one rank.
class SparseSolver final : public LinearSolver {
public:
    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) override;

private:
    void eliminate(const Matrix& matrix) override;

    Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>> lu_;
};

} // namespace fem

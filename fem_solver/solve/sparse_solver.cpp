// SPDX-License-Identifier: MIT
#include "fem_solver/solve/sparse_solver.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace fem {

void SparseSolver::eliminate(const Matrix& matrix)
{
    if (factorisations() == 0) lu_.analyzePattern(matrix);
    lu_.factorize(matrix);
    base::require(lu_.info() == Eigen::Success, base::ExitCode::numerical_failure, "the matrix is singular (",
                  lu_.lastErrorMessage(), "): are supports missing, or a material or mass zero?");
}

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right_hand_side) { return lu_.solve(right_hand_side); }

} // namespace fem

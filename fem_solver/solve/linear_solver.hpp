// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/sparse_matrix.hpp"

namespace fem {

/// Solver of linear systems with a matrix that is kept until the next call of `factorise`: tangents of the body, not
/// symmetric in general, with the rows of this rank's own entries complete.
class LinearSolver {
public:
    virtual ~LinearSolver() = default;

    /// Takes a new matrix; its pattern must be that of the first one. Collective.
    /// \throws base::Error numerical_failure on all ranks when the matrix is singular, so far as the solver can tell.
    void factorise(const Matrix& matrix)
    {
        eliminate(matrix);
        ++factorisations_;
    }
    /// Own entries of the right-hand side to all local entries of the solution. Collective.
    /// \throws base::Error numerical_failure on all ranks when an iteration does not converge.
    virtual Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) = 0;
    /// Number of factorisations so far.
    long factorisations() const { return factorisations_; }

private:
    virtual void eliminate(const Matrix& matrix) = 0;

    long factorisations_ = 0;
};

} // namespace fem

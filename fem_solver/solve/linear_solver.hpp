// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/sparse_matrix.hpp"

#include <memory>
#include <vector>

namespace fem {

/// Direct solver with a factorisation that is kept until the next call of `factorise`.
///
/// Banded LU with row pivoting after a reverse Cuthill-McKee renumbering: the matrices need not be symmetric, and for
/// slender bodies of a few thousand unknowns its back substitution is several times faster than a general sparse one.
class LinearSolver {
public:
    /// \throws base::Error numerical_failure when the matrix is singular, naming the unknown.
    void factorise(const Matrix& matrix);
    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;
    bool ready() const { return factorisations_ > 0; }
    /// Number of factorisations so far.
    long factorisations() const { return factorisations_; }

private:
    void renumber(const Matrix& matrix);
    void eliminate();

    double* column(int j) { return band_.data() + static_cast<std::size_t>(j) * height_ + 2 * width_; }
    const double* column(int j) const { return band_.data() + static_cast<std::size_t>(j) * height_ + 2 * width_; }

    int size_ = 0;
    int width_ = 0;             // half bandwidth of the renumbered matrix
    int height_ = 0;            // 3 width + 1: room for the fill of pivoting
    int upper_ = 0;             // bandwidth above the diagonal that pivoting has left
    std::vector<int> position_; // new number of an unknown
    std::vector<int> pivots_;
    std::vector<double> band_; // entry (i, j) at column(j)[i - j]
    mutable std::vector<double> work_;
    long factorisations_ = 0;
};

} // namespace fem

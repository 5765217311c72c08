// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/solve/linear_solver.hpp"

#include <vector>

namespace fem {

/// Banded LU with row pivoting after a reverse Cuthill-McKee renumbering, on one rank: the matrices need not be
/// symmetric, and for slender bodies of a few thousand unknowns its back substitution is several times faster than a
/// general sparse one.
class BandSolver final : public LinearSolver {
public:
    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) override;
    /// Half bandwidth that matrices of this pattern have after the renumbering.
    static int width(const Matrix& pattern);

private:
    void eliminate(const Matrix& matrix) override;
    void renumber(const Matrix& matrix);
    void decompose();

    double* column(int j) { return band_.data() + static_cast<std::size_t>(j) * height_ + 2 * width_; }
    const double* column(int j) const { return band_.data() + static_cast<std::size_t>(j) * height_ + 2 * width_; }

    int size_ = 0;
    int width_ = 0;             // half bandwidth of the renumbered matrix
    int height_ = 0;            // 3 width + 1: room for the fill of pivoting
    int upper_ = 0;             // bandwidth above the diagonal that pivoting has left
    std::vector<int> position_; // new number of an unknown
    std::vector<int> pivots_;
    std::vector<double> band_; // entry (i, j) at column(j)[i - j]
    std::vector<double> work_;
};

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/solve/band_solver.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>

namespace fem {
namespace {

/// Breadth-first levels from a start, low degrees first; the last unknown reached is far from the start.
std::vector<int> breadth_first(const Matrix& matrix, int start, const std::vector<char>& done)
{
    const auto degree = [&](int i) { return matrix.outerIndexPtr()[i + 1] - matrix.outerIndexPtr()[i]; };
    std::vector<char> seen = done;
    std::vector<int> order{start};
    seen[start] = 1;
    for (std::size_t next = 0; next < order.size(); ++next) {
        const std::size_t first = order.size();
        for (Matrix::InnerIterator entry(matrix, order[next]); entry; ++entry)
            if (!seen[entry.row()]) {
                seen[entry.row()] = 1;
                order.push_back(static_cast<int>(entry.row()));
            }
        std::sort(order.begin() + first, order.end(),
                  [&](int a, int b) { return degree(a) != degree(b) ? degree(a) < degree(b) : a < b; });
    }
    return order;
}

} // namespace

void BandSolver::renumber(const Matrix& matrix)
{
    size_ = static_cast<int>(matrix.rows());
    position_.assign(size_, -1);
    std::vector<char> done(size_, 0);
    int next = size_;
    for (int i = 0; i < size_; ++i) {
        if (done[i]) continue;
        const int far = breadth_first(matrix, i, done).back();
        for (const int j : breadth_first(matrix, breadth_first(matrix, far, done).back(), done)) {
            position_[j] = --next;
            done[j] = 1;
        }
    }
    width_ = 0;
    for (int j = 0; j < size_; ++j)
        for (Matrix::InnerIterator entry(matrix, j); entry; ++entry)
            width_ = std::max(width_, std::abs(position_[entry.row()] - position_[j]));
    height_ = 3 * width_ + 1;
    pivots_.resize(size_);
    work_.resize(size_);
}

int BandSolver::width(const Matrix& pattern)
{
    BandSolver solver;
    solver.renumber(pattern);
    return solver.width_;
}

void BandSolver::eliminate(const Matrix& matrix)
{
    if (size_ != matrix.rows()) renumber(matrix);
    band_.assign(static_cast<std::size_t>(size_) * height_, 0.0);
    for (int j = 0; j < size_; ++j)
        for (Matrix::InnerIterator entry(matrix, j); entry; ++entry)
            column(position_[j])[position_[entry.row()] - position_[j]] = entry.value();
    decompose();
}

void BandSolver::decompose()
{
    int reach = 0; // last column that rows up to the present pivot extend to
    upper_ = 0;
    for (int k = 0; k < size_; ++k) {
        double* pivot_column = column(k);
        const int below = std::min(width_, size_ - 1 - k);
        int p = 0;
        for (int i = 1; i <= below; ++i)
            if (std::abs(pivot_column[i]) > std::abs(pivot_column[p])) p = i;
        pivots_[k] = k + p;
        if (!(std::abs(pivot_column[p]) > 0)) {
            const auto unknown = std::find(position_.begin(), position_.end(), k) - position_.begin();
            throw base::Error(base::ExitCode::numerical_failure,
                              base::text("the matrix is singular at unknown ", unknown,
                                         ": are supports missing, or a material or mass zero?"));
        }
        if (p > 0) std::swap(pivot_column[0], pivot_column[p]);
        const double inverse = 1 / pivot_column[0];
        for (int i = 1; i <= below; ++i) pivot_column[i] *= inverse;
        reach = std::max(reach, std::min(k + p + width_, size_ - 1));
        upper_ = std::max(upper_, reach - k);
        for (int j = k + 1; j <= reach; ++j) {
            double* target = column(j) + (k - j);
            if (p > 0) std::swap(target[0], target[p]);
            const double factor = target[0];
            if (factor == 0) continue;
            for (int i = 1; i <= below; ++i) target[i] -= factor * pivot_column[i];
        }
    }
}

Eigen::VectorXd BandSolver::solve(const Eigen::VectorXd& right_hand_side)
{
    double* x = work_.data();
    for (int i = 0; i < size_; ++i) x[position_[i]] = right_hand_side[i];
    for (int k = 0; k < size_; ++k) {
        if (pivots_[k] != k) std::swap(x[k], x[pivots_[k]]);
        const double* lower = column(k);
        const int below = std::min(width_, size_ - 1 - k);
        const double known = x[k];
        for (int i = 1; i <= below; ++i) x[k + i] -= lower[i] * known;
    }
    for (int k = size_ - 1; k >= 0; --k) {
        const double* upper = column(k);
        const int above = std::min(upper_, k);
        const double known = x[k] /= upper[0];
        for (int i = 1; i <= above; ++i) x[k - i] -= upper[-i] * known;
    }
    Eigen::VectorXd result(size_);
    for (int i = 0; i < size_; ++i) result[i] = x[position_[i]];
    return result;
}

} // namespace fem

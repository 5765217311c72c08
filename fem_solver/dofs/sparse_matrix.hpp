// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/mesh/mesh.hpp"

#include <Eigen/SparseCore>

namespace fem {

using Matrix = Eigen::SparseMatrix<double>;

/// Where element matrices go: one compressed pattern that mass, stiffness and damping share, so that
/// K + c M is a sum of value arrays, and the place of each element entry, looked up once.
class MatrixPattern {
public:
    explicit MatrixPattern(const Mesh& mesh);

    /// A matrix of zeros with the pattern.
    const Matrix& zero() const { return zero_; }
    /// Adds the dense matrix of an element (n x n, n = nodes per element * dimension, node by node).
    void add(Matrix& matrix, int element, const Eigen::Ref<const Eigen::MatrixXd>& dense) const;
    /// Adds a dense D x D block that couples two nodes of one element.
    void add_block(Matrix& matrix, int row_node, int column_node, const Eigen::Ref<const Eigen::MatrixXd>& block) const;
    /// Adds to one entry, which must be part of the pattern (nodes of one element).
    void add_entry(Matrix& matrix, int row, int column, double value) const;

private:
    int place(int row, int column) const;

    int dimension_;
    int element_dofs_;
    Matrix zero_;
    std::vector<int> places_; ///< elements * element_dofs^2, column by column
};

} // namespace fem

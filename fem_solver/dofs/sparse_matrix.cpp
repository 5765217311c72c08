// SPDX-License-Identifier: MIT
#include "fem_solver/dofs/sparse_matrix.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>

namespace fem {
namespace {

/// Sorted neighbours of each node: the nodes that share an element with it, itself included.
std::vector<std::vector<int>> node_graph(const Mesh& mesh)
{
    std::vector<std::vector<int>> graph(mesh.nodes());
    const int n = mesh.nodes_per_element();
    for (int e = 0; e < mesh.elements(); ++e) {
        const int* nodes = mesh.connectivity.data() + static_cast<std::size_t>(e) * n;
        for (int a = 0; a < n; ++a) graph[nodes[a]].insert(graph[nodes[a]].end(), nodes, nodes + n);
    }
    for (auto& row : graph) {
        std::ranges::sort(row);
        row.erase(std::unique(row.begin(), row.end()), row.end());
    }
    return graph;
}

} // namespace

MatrixPattern::MatrixPattern(const Mesh& mesh)
    : dimension_(mesh.dimension),
      element_dofs_(mesh.nodes_per_element() * mesh.dimension),
      zero_(mesh.nodes() * mesh.dimension, mesh.nodes() * mesh.dimension)
{
    std::vector<Eigen::Triplet<double>> entries;
    const auto graph = node_graph(mesh);
    for (int i = 0; i < mesh.nodes(); ++i)
        for (const int j : graph[i])
            for (int k = 0; k < dimension_; ++k)
                for (int l = 0; l < dimension_; ++l) entries.emplace_back(i * dimension_ + k, j * dimension_ + l, 0.0);
    zero_.setFromTriplets(entries.begin(), entries.end());
    zero_.makeCompressed();
    const int n = mesh.nodes_per_element();
    places_.reserve(static_cast<std::size_t>(mesh.elements()) * element_dofs_ * element_dofs_);
    for (int e = 0; e < mesh.elements(); ++e) {
        const int* nodes = mesh.connectivity.data() + static_cast<std::size_t>(e) * n;
        for (int j = 0; j < element_dofs_; ++j)
            for (int i = 0; i < element_dofs_; ++i)
                places_.push_back(place(nodes[i / dimension_] * dimension_ + i % dimension_,
                                        nodes[j / dimension_] * dimension_ + j % dimension_));
    }
}

int MatrixPattern::place(int row, int column) const
{
    const int* begin = zero_.innerIndexPtr() + zero_.outerIndexPtr()[column];
    const int* end = zero_.innerIndexPtr() + zero_.outerIndexPtr()[column + 1];
    const int* found = std::lower_bound(begin, end, row);
    base::ensure(found != end && *found == row, "entry outside the matrix pattern");
    return static_cast<int>(found - zero_.innerIndexPtr());
}

void MatrixPattern::add(Matrix& matrix, int element, const Eigen::Ref<const Eigen::MatrixXd>& dense) const
{
    const int* place = places_.data() + static_cast<std::size_t>(element) * element_dofs_ * element_dofs_;
    double* values = matrix.valuePtr();
    for (int j = 0; j < element_dofs_; ++j)
        for (int i = 0; i < element_dofs_; ++i) values[*place++] += dense(i, j);
}

void MatrixPattern::add_block(Matrix& matrix, int row_node, int column_node,
                              const Eigen::Ref<const Eigen::MatrixXd>& block) const
{
    for (int l = 0; l < dimension_; ++l)
        for (int k = 0; k < dimension_; ++k)
            matrix.valuePtr()[place(row_node * dimension_ + k, column_node * dimension_ + l)] += block(k, l);
}

void MatrixPattern::add_entry(Matrix& matrix, int row, int column, double value) const
{
    matrix.valuePtr()[place(row, column)] += value;
}

} // namespace fem

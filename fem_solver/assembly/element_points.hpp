// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/sparse_matrix.hpp"
#include "fem_solver/element/simplex_rules.hpp"
#include "fem_solver/material/elastic.hpp"

#include <Eigen/LU>

#include <span>

namespace fem {

/// Reference geometry of all elements of one shape at their integration points, and what every formulation needs of it.
template<class Shape> class ElementPoints {
public:
    static constexpr int D = Shape::dimension;
    static constexpr int N = Shape::nodes;
    using Nodal = Eigen::Matrix<double, D, N>; // one column per node
    using Modes = Eigen::Matrix<double, D, D>;
    using Stiffness = Eigen::Matrix<double, D * N, D * N>;

    struct Point {
        Nodal gradient; // dN_a/dX [1/m]
        Modes enhanced; // G_i [1/m], zero without enhancement
        double volume;  // weight times Jacobian [m^3] (2D: m^2)
    };

    /// \param rule number or degree of integration_points.
    ElementPoints(const Mesh& mesh, int rule)
        : connectivity_(mesh.connectivity),
          coordinates_(mesh.coordinates),
          own_elements_(mesh.own_elements()),
          rule_(integration_points<Shape>(rule))
    {
        for (int e = 0; e < elements(); ++e) {
            const Nodal x = positions(e);
            for (const auto& gauss : rule_) {
                const Nodal reference = Shape::gradients(gauss.xi);
                const Modes jacobian = times_transposed(x, reference);
                points_.push_back(
                    {jacobian.inverse().transpose() * reference, Modes::Zero(), gauss.weight * jacobian.determinant()});
            }
        }
    }

    int elements() const { return static_cast<int>(connectivity_.size()) / N; }
    int own_elements() const { return own_elements_; }
    /// Integration points of each element.
    int count() const { return static_cast<int>(rule_.size()); }
    /// Integration points of all elements.
    std::size_t all() const { return points_.size(); }
    const std::vector<GaussPoint<D>>& rule() const { return rule_; }
    const int* nodes_of(int element) const { return connectivity_.data() + static_cast<std::size_t>(element) * N; }
    /// The integration points of an element.
    std::span<Point> of(int element) { return {points_.data() + first(element), rule_.size()}; }
    std::span<const Point> of(int element) const { return {points_.data() + first(element), rule_.size()}; }

    Nodal gather(const Eigen::Ref<const Eigen::VectorXd>& field, int element) const
    {
        Nodal u;
        const int* nodes = nodes_of(element);
        for (int a = 0; a < N; ++a) u.col(a) = field.template segment<D>(static_cast<Eigen::Index>(nodes[a]) * D);
        return u;
    }
    void scatter(const Nodal& nodal, int element, Eigen::VectorXd& field) const
    {
        const int* nodes = nodes_of(element);
        for (int a = 0; a < N; ++a) field.template segment<D>(static_cast<Eigen::Index>(nodes[a]) * D) += nodal.col(a);
    }
    Nodal positions(int element) const
    {
        return gather(Eigen::Map<const Eigen::VectorXd>(coordinates_.data(), std::ssize(coordinates_)), element);
    }

    /// a b^T as a plain sum over the nodes: Eigen's blocked product costs seconds of compilation and is no faster here.
    static Modes times_transposed(const Nodal& a, const Nodal& b) { return a.lazyProduct(b.transpose()); }

    /// Adds the consistent mass, integral of rho N_a N_b dV.
    void add_mass(double density, const MatrixPattern& pattern, Matrix& matrix) const
    {
        const auto rule = integration_points<Shape>(Shape::mass_gauss);
        for (int e = 0; e < elements(); ++e) {
            const Nodal x = positions(e);
            Stiffness m = Stiffness::Zero();
            for (const auto& gauss : rule) {
                const auto n = Shape::values(gauss.xi);
                const Modes jacobian = times_transposed(x, Shape::gradients(gauss.xi));
                const double mass = density * gauss.weight * jacobian.determinant();
                for (int b = 0; b < N; ++b)
                    for (int a = 0; a < N; ++a)
                        for (int k = 0; k < D; ++k) m(a * D + k, b * D + k) += mass * n[a] * n[b];
            }
            pattern.add(matrix, e, m);
        }
    }

private:
    std::size_t first(int element) const { return static_cast<std::size_t>(element) * rule_.size(); }

    std::vector<int> connectivity_;
    std::vector<double> coordinates_;
    int own_elements_;
    std::vector<GaussPoint<D>> rule_;
    std::vector<Point> points_;
};

/// A : grad N_b for one node: column k holds d(vec P)/du_k, for F = I + U g^T with entries in column order.
template<int D, class Gradient>
Eigen::Matrix<double, D * D, D> stress_slope(const Tangent<D>& tangent, const Gradient& gradient)
{
    Eigen::Matrix<double, D * D, D> slope = tangent.template leftCols<D>() * gradient[0];
    for (int l = 1; l < D; ++l) slope += tangent.template middleCols<D>(D * l) * gradient[l];
    return slope;
}

/// grad N_a contracted with the stress index of a stress_slope: the D x D block that couples two nodes.
template<int D, class Gradient>
Tensor<D> contract(const Gradient& gradient, const Eigen::Matrix<double, D * D, D>& slope)
{
    Tensor<D> block = gradient[0] * slope.template topRows<D>();
    for (int j = 1; j < D; ++j) block += gradient[j] * slope.template middleRows<D>(D * j);
    return block;
}

/// Adds rows^T A gradient, D x D for each pair of columns: of nodes or modes with nodes.
template<int D, class Rows, class Gradients, class Block>
void add_products(const Tangent<D>& tangent, const Rows& rows, const Gradients& gradient, Block& k)
{
    for (int b = 0; b < gradient.cols(); ++b) {
        const Eigen::Matrix<double, D * D, D> slope = stress_slope<D>(tangent, gradient.col(b));
        for (int a = 0; a < rows.cols(); ++a) k.template block<D, D>(D * a, D * b) += contract<D>(rows.col(a), slope);
    }
}

} // namespace fem

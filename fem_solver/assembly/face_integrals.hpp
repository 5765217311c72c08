// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/sparse_matrix.hpp"
#include "fem_solver/element/face_normal.hpp"
#include "fem_solver/element/simplex_rules.hpp"

namespace fem {

/// A face of shape FaceShape in space: its node ids and the integrals that pressure needs.
template<class FaceShape> struct FaceIntegrals {
    static constexpr int D = FaceShape::dimension + 1;
    static constexpr int N = FaceShape::nodes;
    using Positions = Eigen::Matrix<double, D, N>;
    using Point = GaussPoint<FaceShape::dimension>;
    using Tangents = Eigen::Matrix<double, D, D - 1>;

    static Positions current(const Mesh& mesh, const int* nodes, const Eigen::VectorXd& displacement)
    {
        Positions x;
        for (int a = 0; a < N; ++a)
            for (int k = 0; k < D; ++k) x(k, a) = mesh.node(nodes[a])[k] + displacement[nodes[a] * D + k];
        return x;
    }

    /// dx/dxi. The product of small matrices as a plain sum: Eigen's blocked one costs seconds of compilation.
    static Tangents tangents(const Positions& x, const Point& point)
    {
        return x.lazyProduct(FaceShape::gradients(point.xi).transpose());
    }

    /// Adds -p N_a n da of one integration point.
    static void add_force(const int* nodes, const Positions& x, const Point& point, double pressure,
                          Eigen::VectorXd& force)
    {
        const auto n = FaceShape::values(point.xi);
        const Eigen::Matrix<double, D, 1> f = -pressure * point.weight * face_normal(tangents(x, point));
        for (int a = 0; a < N; ++a) force.template segment<D>(static_cast<Eigen::Index>(nodes[a]) * D) += n[a] * f;
    }

    /// Adds +p N_a d(n da)/dx_b of one integration point.
    static void add_tangent(const MatrixPattern& pattern, const int* nodes, const Positions& x, const Point& point,
                            double pressure, Matrix& matrix)
    {
        const auto n = FaceShape::values(point.xi);
        const Eigen::Matrix<double, D - 1, N> gradients = FaceShape::gradients(point.xi);
        const Tangents along = tangents(x, point);
        for (int b = 0; b < N; ++b) {
            const Eigen::Matrix<double, D - 1, 1> gradient = gradients.col(b);
            const Eigen::Matrix<double, D, D> s = pressure * point.weight * face_normal_derivative(along, gradient);
            for (int a = 0; a < N; ++a) pattern.add_block(matrix, nodes[a], nodes[b], n[a] * s);
        }
    }
};

} // namespace fem

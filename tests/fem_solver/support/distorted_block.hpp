// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/mesh/block_mesh.hpp"

#include <Eigen/Core>

#include <cmath>

namespace fem_test {

/// The linear shape with the same corners.
template<int D, bool simplex> struct LinearShape;
template<> struct LinearShape<2, false> {
    using type = fem::Quad4;
};
template<> struct LinearShape<3, false> {
    using type = fem::Hexa8;
};
template<> struct LinearShape<2, true> {
    using type = fem::Tri3;
};
template<> struct LinearShape<3, true> {
    using type = fem::Tet4;
};

/// A unit square or cube of 3 cells a side whose inner vertices are moved; edges stay straight (middle nodes are the
/// means of their ends), the boundary stays flat.
inline fem::Mesh distorted_block(fem::ElementType type)
{
    const int d = fem::dimension_of(type);
    fem::Mesh mesh =
        fem::make_block({type, std::vector<double>(d, 0.0), std::vector<double>(d, 1.0), std::vector<int>(d, 3)});
    const std::vector<double> straight = mesh.coordinates;
    const auto moved = [&](int node, int k) {
        const double* x = straight.data() + node * d;
        double bump = 0.12;
        for (int m = 0; m < d; ++m) bump *= std::sin(M_PI * x[m]);
        return x[k] + bump * std::sin(1 + 5 * x[(k + 1) % d] + 3 * k);
    };
    fem::with_shape(type, [&](auto shape) {
        using Shape = decltype(shape);
        using Corners = LinearShape<Shape::dimension, fem::is_simplex<Shape>>::type;
        for (int e = 0; e < mesh.elements(); ++e)
            for (int a = 0; a < Shape::nodes; ++a) {
                const int* nodes = mesh.connectivity.data() + e * Shape::nodes;
                Eigen::Matrix<double, Shape::dimension, 1> xi;
                for (int k = 0; k < d; ++k) xi[k] = Shape::corners[a][k];
                const auto weights = Corners::values(xi); // of the corners: 1 at one, or equal at the ends of an edge
                for (int k = 0; k < d; ++k) {
                    double sum = 0;
                    for (int c = 0; c < Corners::nodes; ++c) sum += weights[c] * moved(nodes[c], k);
                    mesh.coordinates[nodes[a] * d + k] = sum;
                }
            }
    });
    return mesh;
}

inline Eigen::Map<const Eigen::VectorXd> positions(const fem::Mesh& mesh)
{
    return {mesh.coordinates.data(), std::ssize(mesh.coordinates)};
}

/// u = H X at every node.
inline Eigen::VectorXd linear_field(const fem::Mesh& mesh, const Eigen::MatrixXd& h)
{
    Eigen::VectorXd u(std::ssize(mesh.coordinates));
    for (int i = 0; i < mesh.nodes(); ++i)
        u.segment(i * mesh.dimension, mesh.dimension) = h * positions(mesh).segment(i * mesh.dimension, mesh.dimension);
    return u;
}

} // namespace fem_test

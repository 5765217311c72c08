// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/mesh/mesh.hpp"

#include <Eigen/Geometry>

namespace fem_test {

/// Volume (2D: area) inside linear facets with outward normals, by Gauss's theorem; quadrilaterals as two triangles.
inline double enclosed(const fem::Mesh& mesh, const std::vector<std::array<int, 4>>& facets)
{
    const auto point = [&](int node) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        for (int k = 0; k < mesh.dimension; ++k) x[k] = mesh.node(node)[k];
        return x;
    };
    double sum = 0;
    for (const auto& f : facets) {
        const Eigen::Vector3d a = point(f[0]), b = point(f[1]);
        if (mesh.dimension == 2) {
            sum += 0.5 * a.cross(b)[2];
            continue;
        }
        const Eigen::Vector3d c = point(f[2]);
        sum += a.dot(b.cross(c)) / 6;
        if (f[3] >= 0) sum += a.dot(c.cross(point(f[3]))) / 6;
    }
    return sum;
}

} // namespace fem_test

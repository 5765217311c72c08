// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/operators/wall_images.hpp"

#include <cmath>
#include <Eigen/LU>

namespace sph {

/// Gives a force to the walls of a group of images: its components along their normals where these are far from
/// parallel, else all to the last.
template<int D>
void share_out(const Vec<D>& force, const ImageGroup& group, const std::vector<MirrorPlane<D>>& planes,
               std::vector<Vec<D>>& on_wall)
{
    const auto plane = [&](int k) { return static_cast<std::size_t>(group.path[static_cast<std::size_t>(k)]); };
    const auto normal = [&](int k) -> const Vec<D>& { return planes[plane(k)].normal; };
    const int last = group.order - 1;
    Vec<D> rest = force;
    if (group.order == 2 && std::abs(normal(0).dot(normal(1))) < 0.7) {
        const double cosine = normal(0).dot(normal(1));
        const double a = force.dot(normal(0)), b = force.dot(normal(1));
        const Vec<D> part = ((a - cosine * b) / (1 - cosine * cosine)) * normal(0);
        on_wall[plane(0)] += part;
        rest -= part;
    } else if (D == 3 && group.order == 3 && group.path[0] != group.path[2]) {
        Mat<D> normals;
        for (int k = 0; k < D; ++k) normals.col(k) = normal(k);
        if (std::abs(normals.determinant()) > 0.3) {
            const Vec<D> share = normals.inverse() * force;
            for (int k = 0; k < last; ++k) {
                on_wall[plane(k)] += share[k] * normal(k);
                rest -= share[k] * normal(k);
            }
        }
    }
    on_wall[plane(last)] += rest;
}

} // namespace sph

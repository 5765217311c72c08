// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace sph {

/// Vector of `D` components.
template<int D> using Vec = Eigen::Matrix<double, D, 1>;

/// Square matrix of `D` x `D` components; gradients are stored as (grad v)(a, b) = d v_a / d x_b.
template<int D> using Mat = Eigen::Matrix<double, D, D>;

} // namespace sph

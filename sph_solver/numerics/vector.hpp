// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace sph {

/// A point or vector in D dimensions (D = 2, 3).
template <int D>
using Vec = Eigen::Matrix<double, D, 1>;

/// A second-order tensor in D dimensions. For gradients the row is the component, the column the derivative:
/// (grad v)(a, b) = dv_a / dx_b, so that (grad v) * dx is the change of v along dx.
template <int D>
using Mat = Eigen::Matrix<double, D, D>;

}  // namespace sph

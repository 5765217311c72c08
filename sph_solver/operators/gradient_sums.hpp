// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/vector.hpp"

#include <vector>

namespace sph {

/// The neighbour sums of pass 1 for one owned particle, over fluid pairs and then over wall images, before any
/// division. With x_ij = x_j - x_i and grad W = |W'(r)| x_ij / r, the gradient of W(|x_i - x_j|) with respect to x_i:
///
///     moment    M    = sum w_j x_ij grad W^T           (the unit matrix where the neighbourhood is full)
///     density   G[f] = sum w_j (f_j - f_i) grad W      for f = rho
///     velocity  G[v] = sum w_j (v_j - v_i) grad W^T
template<int D> struct GradientSums {
    Mat<D> moment = Mat<D>::Zero();   ///< M, symmetric [-]
    Mat<D> velocity = Mat<D>::Zero(); ///< G[v], rows are the components of v [1/s]
    Vec<D> density = Vec<D>::Zero();  ///< G[rho] [kg/m^4]
    double fluid_fill = 0; ///< tr M/D over the fluid pairs alone: 1 deep in the water, 0 for a lone particle [-]
};

/// Row k belongs to the k-th owned particle, as in ReachedNeighbours.
template<int D> using GradientField = std::vector<GradientSums<D>>;

} // namespace sph

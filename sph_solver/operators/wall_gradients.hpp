// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/operators/gradient_sums.hpp"
#include "sph_solver/operators/wall_images.hpp"

namespace sph {

/// Pass 1 at the walls: adds the images that each owned particle sees to its sums of M, G[rho], G[v] as if they were
/// neighbours (operators/gradient_sums.hpp), but for `fluid_divergence`.
/// \pre images.find for the present positions; sums hold one row for each owned particle.
template<int D>
void accumulate_wall_gradients(GradientField<D>& sums, const WallImages<D>& images, const Walls<D>& walls,
                               const PairRecords<D>& records, const FluidModel<D>& model);

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/neighbour_list.hpp"
#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/operators/gradient_sums.hpp"
#include "sph_solver/state/particles.hpp"
#include "sph_solver/walls/walls.hpp"

namespace sph {

/// Pass 1 at the walls: adds the images that each owned particle sees to its sums of M, G[rho], G[v] as if they were
/// neighbours (operators/gradient_sums.hpp). `fluid_divergence` is left as it is.
/// \pre walls.find_contacts for the present positions; sums hold one row for each owned particle.
template<int D>
void accumulate_wall_gradients(GradientField<D>& sums, const Walls<D>& walls, const Particles<D>& particles,
                               const NeighbourList& neighbours, const FluidModel<D>& model);

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/box_grid.hpp"
#include "coupler_lib/coupling/surface.hpp"
#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/walls/walls.hpp"

#include <vector>

namespace sph {

/// Makes the solid's facets, with their motion at the start of the coming step, the moving facets of the walls.
/// Throws Error(bad_input) when the batch is of another dimension.
template<int D> void set_interface_motion(Walls<D>& walls, const coupler::FacetBatch& batch);

/// Where this rank wants to know the facets: the box of its owned particles, widened by `margin`, then rounded
/// outwards to
/// multiples of `step` so that it seldom changes. Empty without particles.
/// \param margin [m], at least 2h + skin + the way that walls and particles go until the next exchange
template<int D> coupler::RegionBox region_of(const Particles<D>& particles, double margin, double step);

/// Resultant of the conservative load, about the origin; 2D: per metre of depth.
struct Resultant {
    std::array<double, 3> force{};  ///< on the solid [N]
    std::array<double, 3> moment{}; ///< on the solid, sum x_c x f_c at the corners' present positions [N m]
};

/// Sum over all ranks of `loads.corner_force`, with the corners where the walls stand now. Collective.
template<int D>
Resultant resultant(const coupler::FacetLoads& loads, const Walls<D>& walls, const coupler::FacetBatch& batch,
                    const base::Communicator& comm);

/// Work that the load does on the solid [J] because a new motion does not begin where the walls ended:
///
///     sum over corners of f_c . (X_c(new) - x_c(old, at the end of the step))
///
/// This rank's part. \pre `walls` are at the end of the step that used the batch `before`; `after` is the new one.
template<int D>
base::ReproducibleSum jump_work(const coupler::FacetLoads& loads, const Walls<D>& walls,
                                const coupler::FacetBatch& before, const coupler::FacetBatch& after);

} // namespace sph

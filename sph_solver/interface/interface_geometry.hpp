// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/box_grid.hpp"
#include "coupler_lib/coupling/surface.hpp"
#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/walls/walls.hpp"

#include <vector>

namespace sph {

/// Where the facets and nodes of an interface stand among those of all interfaces.
struct InterfacePlace {
    std::size_t facet = 0, node = 0; ///< the first
};

/// The facets of several interfaces as one batch, in their order; ids are left out, each solid has its own.
coupler::FacetBatch joined(const std::vector<const coupler::FacetBatch*>& batches);

/// The loads of `count` facets of all.
coupler::FacetLoads part_of(const coupler::FacetLoads& all, std::size_t first, std::size_t count, int dimension);

/// Makes the solid's facets, with their motion at the start of the coming step, the moving facets of the walls.
/// Throws Error(bad_input) when the batch is of another dimension.
template<int D> void set_interface_motion(Walls<D>& walls, const coupler::FacetBatch& batch);

/// Where this rank wants to know the facets: the box of its owned particles, widened by `margin`, then rounded
/// outwards to
/// multiples of `step` so that it seldom changes. Empty without particles.
/// \param margin [m], at least 2h + skin + the way that walls and particles go until the next exchange
template<int D> coupler::RegionBox region_of(const Particles<D>& particles, double margin, double step);

/// Force [N] and moment about the origin [N m] of the conservative load on one interface, three numbers each, with the corners
/// where the walls stand now; 2D: per metre of depth. This rank's part.
template<int D>
std::array<base::ReproducibleSum, 6> resultant(const coupler::FacetLoads& loads, const Walls<D>& walls,
                                               const coupler::FacetBatch& batch, const InterfacePlace& place);

/// Works of the load of the last step on one interface [J].
struct ExchangeWorks {
    /// Because a new motion does not begin where the walls ended: sum over corners of f_c . (X_c(new) - x_c(end of the step))
    base::ReproducibleSum jump;
    /// Along the solid's way over the window: sum of f_c . (X_c(new) - X_c(old))
    base::ReproducibleSum path;
};

/// This rank's part. \pre `walls` are at the end of the window that began with the batch `before`; `after` is the new one.
template<int D>
ExchangeWorks exchange_works(const coupler::FacetLoads& loads, const Walls<D>& walls, const InterfacePlace& place,
                             const coupler::FacetBatch& before, const coupler::FacetBatch& after);

} // namespace sph

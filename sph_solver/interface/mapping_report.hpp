// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/coupling/surface.hpp"
#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/interface/interface_geometry.hpp"

#include <string>

namespace sph {

/// How surface and water meet at the start, and what their mapping is worth.
struct MappingReport {
    std::int64_t facets = 0;    ///< of the solid that any rank of the fluid was sent
    std::int64_t touched = 0;   ///< those that bear water
    std::int64_t points = 0;    ///< wall points of particles on them
    double area = 0;            ///< of all facets [m^(D-1)]
    double nearest = 0;         ///< smallest distance of a particle from a facet [dx]; 0 without points
    double layer = 0;           ///< mean distance of those within dx [dx]: 0.5 where particles lie against the wall
    double constant_error = 0;  ///< largest |sum_n H_n - 1|: what a uniform motion loses
    double centre_distance = 0; ///< largest |sum_n H_n x_n - x_w| [dx]: what a turn by one radian loses, near edges
};

/// Looks at the contacts of an interface as they are. Collective. \param batch that its walls were made of.
/// \param place of the batch among those of all interfaces  \param spacing dx [m].
template<int D>
MappingReport examine_mapping(const Walls<D>& walls, const coupler::FacetBatch& batch, const InterfacePlace& place,
                              double spacing, const base::Communicator& comm);

/// In one line.
std::string describe(const MappingReport& report, const std::string& name, int dimension, double spacing);

} // namespace sph

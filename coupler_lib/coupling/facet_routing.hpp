// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/packet.hpp"
#include "coupler_lib/coupling/surface.hpp"

#include <cstdint>
#include <vector>

namespace coupler {

/// The box around all points.
RegionBox box_around(const std::vector<double>& points, int dimension);

/// What of my surface goes to one fluid rank: the facets that touch its region and their nodes. Ids and connectivity
/// travel only when the choice has changed since the last packet.
class FacetRoute {
public:
    /// Chooses the facets whose current box touches `region`. \return true when the choice has changed
    /// \param order  facet indices in ascending order of their ids  \param all  the box around the whole surface
    bool choose(const WetSurface& surface, const std::vector<int>& order, const SurfaceMotion& motion,
                const RegionBox& all, const RegionBox& region);

    /// Appends counts to the header and data to the packet.
    void write(const WetSurface& surface, const SurfaceMotion& motion, bool with_ids, PacketHeader& header,
               PacketWriter& packet);

    /// What was chosen last, as indices into the surface, in the order in which it travels.
    const std::vector<int>& facets() const { return facets_; }
    const std::vector<int>& nodes() const { return nodes_; }

private:
    void list_nodes(const WetSurface& surface);

    std::vector<int> facets_, next_facets_;        ///< indices into the surface
    std::vector<int> nodes_;                       ///< indices into the surface, ascending
    std::vector<std::array<int, 4>> connectivity_; ///< indices into nodes_
    bool first_ = true;
};

/// What one solid rank sent: ids and connectivity as last received, and where they sit in the merged batch.
struct ReceivedFacets {
    std::vector<std::int64_t> facet_ids;
    std::vector<std::int64_t> node_ids;
    std::vector<std::array<int, 4>> facet_nodes; ///< indices into node_ids
    std::vector<int> place;                      ///< of each node in the batch
    bool in_order = false;                       ///< place is 0, 1, 2, ...
    std::vector<int> batch_facet;                ///< of each facet in the batch
};

/// Merges what the solid's ranks sent into one batch sorted by ids; a node sent by several ranks is taken once.
/// Fills everything but the motion, and the places of nodes and facets. Throws base::Error(bad_input) on a facet sent twice.
void merge_topology(std::vector<ReceivedFacets>& parts, FacetBatch& batch);

/// Copies position, velocity and acceleration of one part to their places in the batch.
void merge_motion(const ReceivedFacets& part, PacketReader& packet, FacetBatch& batch);

} // namespace coupler

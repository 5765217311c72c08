// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/packet.hpp"
#include "coupler_lib/coupling/surface.hpp"

#include <cstdint>
#include <vector>

namespace coupler {

/// What of my surface goes to one fluid rank: the facets that touch its region and their nodes. Ids and connectivity
/// travel only when the choice has changed since the last packet.
class FacetRoute {
public:
    /// Chooses the facets whose current box touches `region`. \return true when the choice has changed
    /// \param order  facet indices in ascending order of their ids
    bool choose(const WetSurface& surface, const std::vector<int>& order, const SurfaceMotion& motion,
                const RegionBox& region);

    /// Appends counts to the header and data to the packet.
    void write(const WetSurface& surface, const SurfaceMotion& motion, bool with_ids, PacketHeader& header,
               PacketWriter& packet);

private:
    void list_nodes(const WetSurface& surface);

    std::vector<int> facets_, next_facets_;        ///< indices into the surface
    std::vector<int> nodes_;                       ///< indices into the surface
    std::vector<std::array<int, 4>> connectivity_; ///< indices into nodes_
    std::vector<double> columns_;                  ///< scratch
    bool first_ = true;
};

/// What one solid rank sent: ids and connectivity as last received, and where they sit in the merged batch.
struct ReceivedFacets {
    std::vector<std::int64_t> facet_ids;
    std::vector<std::int64_t> node_ids;
    std::vector<std::array<int, 4>> facet_nodes; ///< indices into node_ids
    std::vector<int> place;                      ///< of each node in the batch
};

/// Merges what the solid's ranks sent into one batch sorted by ids; a node sent by several ranks is taken once.
/// Fills everything but the motion, and the nodes' places. Throws base::Error(bad_input) on a facet sent twice.
void merge_topology(std::vector<ReceivedFacets>& parts, FacetBatch& batch);

/// Copies position, velocity and acceleration of one part to their places in the batch.
void merge_motion(const ReceivedFacets& part, PacketReader& packet, std::vector<double>& scratch, FacetBatch& batch);

} // namespace coupler

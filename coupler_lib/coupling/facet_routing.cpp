// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/facet_routing.hpp"

#include "coupler_lib/coupling/facet_geometry.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <numeric>

namespace coupler {
namespace {

/// Appends the values of the chosen nodes to the packet.
void put_nodes(const std::vector<double>& values, const std::vector<int>& nodes, int dimension,
               std::vector<double>& scratch, PacketWriter& packet)
{
    scratch.clear();
    for (const int node : nodes) {
        const double* value = values.data() + static_cast<std::ptrdiff_t>(node) * dimension;
        scratch.insert(scratch.end(), value, value + dimension);
    }
    packet.put(scratch);
}

void take_nodes(PacketReader& packet, const std::vector<int>& places, int dimension, std::vector<double>& scratch,
                std::vector<double>& values)
{
    packet.take(scratch, places.size() * static_cast<std::size_t>(dimension));
    const double* from = scratch.data();
    for (const int place : places) {
        std::copy(from, from + dimension, values.data() + static_cast<std::ptrdiff_t>(place) * dimension);
        from += dimension;
    }
}

struct FacetPlace {
    std::int64_t id;
    int part;
    int index;
};

std::vector<FacetPlace> sorted_facets(const std::vector<ReceivedFacets>& parts)
{
    std::vector<FacetPlace> places;
    for (std::size_t part = 0; part < parts.size(); ++part)
        for (std::size_t k = 0; k < parts[part].facet_ids.size(); ++k)
            places.push_back({parts[part].facet_ids[k], static_cast<int>(part), static_cast<int>(k)});
    std::sort(places.begin(), places.end(), [](const FacetPlace& a, const FacetPlace& b) { return a.id < b.id; });
    for (std::size_t k = 1; k < places.size(); ++k)
        base::require_input(places[k - 1].id != places[k].id, "wet facet ", places[k].id,
                            " was sent by two ranks of the solid (", places[k - 1].part, " and ", places[k].part,
                            " of its own): facet ids must be unique");
    return places;
}

} // namespace

bool FacetRoute::choose(const WetSurface& surface, const std::vector<int>& order, const SurfaceMotion& motion,
                        const RegionBox& region)
{
    next_facets_.clear();
    for (const int facet : order)
        if (touches(surface.facet_nodes[static_cast<std::size_t>(facet)], motion.position, surface.dimension, region))
            next_facets_.push_back(facet);
    if (!first_ && next_facets_ == facets_) return false;
    first_ = false;
    facets_.swap(next_facets_);
    list_nodes(surface);
    return true;
}

void FacetRoute::list_nodes(const WetSurface& surface)
{
    std::vector<int> place(surface.node_ids.size(), -1);
    nodes_.clear();
    connectivity_.clear();
    for (const int facet : facets_) {
        std::array<int, 4> mine{-1, -1, -1, -1};
        for (std::size_t k = 0; k < 4; ++k) {
            const int node = surface.facet_nodes[static_cast<std::size_t>(facet)][k];
            if (node < 0) break;
            int& slot = place[static_cast<std::size_t>(node)];
            if (slot < 0) {
                slot = static_cast<int>(nodes_.size());
                nodes_.push_back(node);
            }
            mine[k] = slot;
        }
        connectivity_.push_back(mine);
    }
}

void FacetRoute::write(const WetSurface& surface, const SurfaceMotion& motion, bool with_ids, PacketHeader& header,
                       PacketWriter& packet)
{
    header.facets = static_cast<std::int64_t>(facets_.size());
    header.nodes = static_cast<std::int64_t>(nodes_.size());
    if (with_ids) {
        header.flags |= with_topology;
        for (const int facet : facets_) packet.put(surface.facet_ids[static_cast<std::size_t>(facet)]);
        for (const int node : nodes_) packet.put(surface.node_ids[static_cast<std::size_t>(node)]);
        packet.put(connectivity_);
    }
    put_nodes(motion.position, nodes_, surface.dimension, columns_, packet);
    put_nodes(motion.velocity, nodes_, surface.dimension, columns_, packet);
    put_nodes(motion.acceleration, nodes_, surface.dimension, columns_, packet);
}

void merge_topology(std::vector<ReceivedFacets>& parts, FacetBatch& batch)
{
    batch.node_ids.clear();
    for (const auto& part : parts)
        batch.node_ids.insert(batch.node_ids.end(), part.node_ids.begin(), part.node_ids.end());
    std::sort(batch.node_ids.begin(), batch.node_ids.end());
    batch.node_ids.erase(std::unique(batch.node_ids.begin(), batch.node_ids.end()), batch.node_ids.end());
    for (auto& part : parts) {
        part.place.clear();
        for (const std::int64_t id : part.node_ids) {
            const auto at = std::lower_bound(batch.node_ids.begin(), batch.node_ids.end(), id);
            part.place.push_back(static_cast<int>(at - batch.node_ids.begin()));
        }
    }
    batch.facet_ids.clear();
    batch.facet_nodes.clear();
    batch.facet_owner.clear();
    for (const FacetPlace& facet : sorted_facets(parts)) {
        const auto& part = parts[static_cast<std::size_t>(facet.part)];
        std::array<int, 4> nodes = part.facet_nodes[static_cast<std::size_t>(facet.index)];
        for (int& node : nodes)
            if (node >= 0) node = part.place[static_cast<std::size_t>(node)];
        batch.facet_ids.push_back(facet.id);
        batch.facet_nodes.push_back(nodes);
        batch.facet_owner.push_back(facet.part);
    }
    const std::size_t values = batch.node_ids.size() * static_cast<std::size_t>(batch.dimension);
    for (auto* column : {&batch.motion.position, &batch.motion.velocity, &batch.motion.acceleration})
        column->resize(values);
}

void merge_motion(const ReceivedFacets& part, PacketReader& packet, std::vector<double>& scratch, FacetBatch& batch)
{
    take_nodes(packet, part.place, batch.dimension, scratch, batch.motion.position);
    take_nodes(packet, part.place, batch.dimension, scratch, batch.motion.velocity);
    take_nodes(packet, part.place, batch.dimension, scratch, batch.motion.acceleration);
}

} // namespace coupler

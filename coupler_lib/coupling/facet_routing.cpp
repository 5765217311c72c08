// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/facet_routing.hpp"

#include "coupler_lib/coupling/facet_geometry.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace coupler {
namespace {

/// Appends the values of the chosen nodes to the packet, D components each.
template<int D> void put_nodes(const std::vector<double>& values, const std::vector<int>& nodes, PacketWriter& packet)
{
    constexpr std::size_t bytes = D * sizeof(double);
    if (nodes.size() * D == values.size()) return packet.put(values); // all of them, in order
    char* to = packet.room(nodes.size() * bytes);
    for (std::size_t k = 0; k < nodes.size(); ++k)
        std::memcpy(to + k * bytes, values.data() + static_cast<std::ptrdiff_t>(nodes[k]) * D, bytes);
}

/// \param in_order  the places are 0, 1, 2, ...
template<int D>
void take_nodes(PacketReader& packet, const std::vector<int>& places, bool in_order, std::vector<double>& values)
{
    constexpr std::size_t bytes = D * sizeof(double);
    const char* from = packet.view(places.size(), bytes);
    if (in_order) {
        if (!values.empty()) std::memcpy(values.data(), from, places.size() * bytes);
        return;
    }
    for (std::size_t k = 0; k < places.size(); ++k)
        std::memcpy(values.data() + static_cast<std::ptrdiff_t>(places[k]) * D, from + k * bytes, bytes);
}

bool is_inside(const RegionBox& box, const RegionBox& region, int dimension)
{
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
        if (!(box.low[d] >= region.low[d] && box.high[d] <= region.high[d])) return false;
    return true;
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

RegionBox box_around(const std::vector<double>& points, int dimension)
{
    RegionBox box;
    const auto components = static_cast<std::size_t>(dimension);
    for (std::size_t k = 0; k < points.size(); k += components)
        for (std::size_t d = 0; d < components; ++d) {
            box.low[d] = std::min(box.low[d], points[k + d]);
            box.high[d] = std::max(box.high[d], points[k + d]);
        }
    return box;
}

bool FacetRoute::choose(const WetSurface& surface, const std::vector<int>& order, const SurfaceMotion& motion,
                        const RegionBox& all, const RegionBox& region)
{
    if (is_inside(all, region, surface.dimension)) {
        if (!first_ && facets_.size() == order.size()) return false;
        next_facets_ = order;
    } else {
        next_facets_.clear();
        for (const int facet : order)
            if (touches(surface.facet_nodes[static_cast<std::size_t>(facet)], motion.position, surface.dimension,
                        region))
                next_facets_.push_back(facet);
    }
    if (!first_ && next_facets_ == facets_) return false;
    first_ = false;
    facets_.swap(next_facets_);
    list_nodes(surface);
    return true;
}

void FacetRoute::list_nodes(const WetSurface& surface)
{
    std::vector<int> place(surface.node_ids.size(), -1);
    for (const int facet : facets_)
        for (const int node : surface.facet_nodes[static_cast<std::size_t>(facet)])
            if (node >= 0) place[static_cast<std::size_t>(node)] = 0;
    nodes_.clear();
    for (std::size_t node = 0; node < place.size(); ++node) {
        if (place[node] < 0) continue;
        place[node] = static_cast<int>(nodes_.size());
        nodes_.push_back(static_cast<int>(node));
    }
    connectivity_.clear();
    for (const int facet : facets_) {
        std::array<int, 4> mine = surface.facet_nodes[static_cast<std::size_t>(facet)];
        for (int& node : mine) node = node < 0 ? -1 : place[static_cast<std::size_t>(node)];
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
    for (const auto* values : {&motion.position, &motion.velocity, &motion.acceleration})
        surface.dimension == 2 ? put_nodes<2>(*values, nodes_, packet) : put_nodes<3>(*values, nodes_, packet);
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
        part.in_order = part.node_ids == batch.node_ids;
    }
    batch.facet_ids.clear();
    batch.facet_nodes.clear();
    for (auto& part : parts) part.batch_facet.resize(part.facet_ids.size());
    for (const FacetPlace& facet : sorted_facets(parts)) {
        auto& part = parts[static_cast<std::size_t>(facet.part)];
        std::array<int, 4> nodes = part.facet_nodes[static_cast<std::size_t>(facet.index)];
        for (int& node : nodes)
            if (node >= 0) node = part.place[static_cast<std::size_t>(node)];
        part.batch_facet[static_cast<std::size_t>(facet.index)] = static_cast<int>(batch.facet_ids.size());
        batch.facet_ids.push_back(facet.id);
        batch.facet_nodes.push_back(nodes);
    }
    const std::size_t values = batch.node_ids.size() * static_cast<std::size_t>(batch.dimension);
    for (auto* column : {&batch.motion.position, &batch.motion.velocity, &batch.motion.acceleration})
        column->resize(values);
}

void merge_motion(const ReceivedFacets& part, PacketReader& packet, FacetBatch& batch)
{
    for (auto* values : {&batch.motion.position, &batch.motion.velocity, &batch.motion.acceleration})
        batch.dimension == 2 ? take_nodes<2>(packet, part.place, part.in_order, *values)
                             : take_nodes<3>(packet, part.place, part.in_order, *values);
}

} // namespace coupler

// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/load_packet.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cstring>

namespace coupler {
namespace {

template<class T> T item_at(const char* items, std::size_t index)
{
    T item;
    std::memcpy(&item, items + index * sizeof(T), sizeof(T));
    return item;
}

template<class Sum> void zero(std::vector<Sum>& items) { std::fill(items.begin(), items.end(), Sum()); }

} // namespace

void check_load_sizes(const FacetLoads& loads, const FacetBatch& used, LoadKind applied)
{
    const std::size_t facets = used.facet_ids.size();
    const std::size_t forces = loads.corner_force.size();
    base::require_input(forces == 0 || forces == 4 * facets * static_cast<std::size_t>(used.dimension),
                        "the conservative load has ", forces, " corner forces for ", facets, " facets in ",
                        used.dimension, "D");
    const std::size_t weights = loads.weight.size();
    base::require_input((weights == 0 || weights == facets) && loads.weighted_pressure.size() == weights &&
                            loads.full_weight.size() == weights,
                        "the averaged load has ", weights, " weights, ", loads.weighted_pressure.size(),
                        " pressures and ", loads.full_weight.size(), " full weights for ", facets, " facets");
    if (forces == 0 && weights == 0) return; // no load at all: the greeting
    base::require_input(facets == 0 || (applied == LoadKind::averaged ? weights : forces) > 0,
                        "the interface applies the ", applied == LoadKind::averaged ? "averaged" : "conservative",
                        " load, but the fluid sends only the other one");
}

/// Nodal sums over the corners of this part's facets.
template<int D> void LoadWriter::add_corners(const ReceivedFacets& part, const FacetLoads& loads)
{
    constexpr std::size_t corners = D == 2 ? 2 : 4;
    sums_.assign(part.node_ids.size() * D, {});
    for (std::size_t k = 0; k < part.facet_nodes.size(); ++k) {
        const auto* force = &loads.corner_force[4 * D * static_cast<std::size_t>(part.batch_facet[k])];
        for (std::size_t corner = 0; corner < corners && part.facet_nodes[k][corner] >= 0; ++corner)
            for (std::size_t d = 0; d < D; ++d)
                sums_[static_cast<std::size_t>(part.facet_nodes[k][corner]) * D + d] += force[corner * D + d];
    }
}

void LoadWriter::put_force(const ReceivedFacets& part, const FacetLoads& loads, int dimension, PacketWriter& packet)
{
    dimension == 2 ? add_corners<2>(part, loads) : add_corners<3>(part, loads);
    if (!only_rank_) return packet.put(sums_);
    char* to = packet.room(sums_.size() * sizeof(double));
    for (const auto& sum : sums_) {
        const double force = sum.value();
        std::memcpy(to, &force, sizeof(double));
        to += sizeof(double);
    }
}

void LoadWriter::write(const ReceivedFacets& part, const FacetLoads& loads, int dimension, PacketHeader& header,
                       PacketWriter& packet)
{
    header.facets = static_cast<std::int64_t>(part.facet_ids.size());
    header.nodes = static_cast<std::int64_t>(part.node_ids.size());
    if (!loads.corner_force.empty()) {
        header.flags |= only_rank_ ? with_force | force_is_whole : with_force;
        put_force(part, loads, dimension, packet);
    }
    if (loads.weight.empty()) return;
    header.flags |= with_pressure;
    for (const int facet : part.batch_facet) packet.put(loads.weight[static_cast<std::size_t>(facet)]);
    for (const int facet : part.batch_facet) packet.put(loads.weighted_pressure[static_cast<std::size_t>(facet)]);
    for (const int facet : part.batch_facet) packet.put(loads.full_weight[static_cast<std::size_t>(facet)]);
}

LoadSum::LoadSum(const WetSurface& surface)
    : dimension_(surface.dimension),
      whole_force_(surface.reference.size()),
      force_(surface.reference.size()),
      weight_(surface.facet_ids.size()),
      weighted_pressure_(surface.facet_ids.size()),
      full_weight_(surface.facet_ids.size())
{}

void LoadSum::clear()
{
    zero(whole_force_);
    if (has_sums_) zero(force_);
    if (has_pressure_) {
        zero(weight_);
        zero(weighted_pressure_);
        zero(full_weight_);
    }
    has_sums_ = has_pressure_ = false;
}

void LoadSum::add(PacketReader& packet, const FacetRoute& given, const std::string& who)
{
    const PacketHeader& header = packet.header();
    if (!header.has(with_force) && !header.has(with_pressure)) return; // nothing to load, or the greeting
    base::require_input(static_cast<std::size_t>(header.nodes) == given.nodes().size() &&
                            static_cast<std::size_t>(header.facets) == given.facets().size(),
                        who, " sent a load on ", header.facets, " facets and ", header.nodes, " nodes, but was given ",
                        given.facets().size(), " facets and ", given.nodes().size(),
                        " nodes: the two sides have lost step with each other");
    if (header.has(with_force)) dimension_ == 2 ? add_force<2>(packet, given) : add_force<3>(packet, given);
    if (header.has(with_pressure)) add_pressure(packet, given);
}

template<int D> void LoadSum::add_force(PacketReader& packet, const FacetRoute& given)
{
    const auto& nodes = given.nodes();
    if (packet.header().has(force_is_whole)) {
        const char* from = packet.view(nodes.size(), D * sizeof(double));
        if (nodes.size() * D == whole_force_.size()) { // all of them, in order
            if (!nodes.empty()) std::memcpy(whole_force_.data(), from, nodes.size() * D * sizeof(double));
            return;
        }
        for (std::size_t k = 0; k < nodes.size(); ++k)
            std::memcpy(&whole_force_[static_cast<std::size_t>(nodes[k]) * D], from + k * D * sizeof(double),
                        D * sizeof(double));
        return;
    }
    has_sums_ = true;
    const char* from = packet.view(nodes.size(), D * sizeof(base::ReproducibleSum));
    for (std::size_t k = 0; k < nodes.size(); ++k)
        for (std::size_t d = 0; d < D; ++d)
            force_[static_cast<std::size_t>(nodes[k]) * D + d] += item_at<base::ReproducibleSum>(from, k * D + d);
}

void LoadSum::add_pressure(PacketReader& packet, const FacetRoute& given)
{
    has_pressure_ = true;
    const std::size_t count = given.facets().size();
    const char* weights = packet.view(count, sizeof(base::ReproducibleSum));
    const char* pressures = packet.view(count, sizeof(base::ReproducibleSum));
    const char* full = packet.view(count, sizeof(double));
    for (std::size_t k = 0; k < count; ++k) {
        const auto facet = static_cast<std::size_t>(given.facets()[k]);
        weight_[facet] += item_at<base::ReproducibleSum>(weights, k);
        weighted_pressure_[facet] += item_at<base::ReproducibleSum>(pressures, k);
        full_weight_[facet] = std::max(full_weight_[facet], item_at<double>(full, k));
    }
}

void LoadSum::write_force(std::vector<double>& force) const
{
    force = whole_force_;
    if (has_sums_)
        std::transform(force_.begin(), force_.end(), force.begin(), [](const auto& sum) { return sum.value(); });
}

void LoadSum::write_pressure(std::vector<double>& pressure, double coverage_limit) const
{
    pressure.assign(weight_.size(), 0.0);
    for (std::size_t facet = 0; facet < weight_.size(); ++facet) {
        const double weight = weight_[facet].value();
        if (weight > 0 && weight >= coverage_limit * full_weight_[facet])
            pressure[facet] = weighted_pressure_[facet].value() / weight;
    }
}

} // namespace coupler

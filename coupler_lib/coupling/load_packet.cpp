// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/load_packet.hpp"

#include "coupler_lib/coupling/checksum.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <algorithm>

namespace coupler {
namespace {

std::size_t corners_that_travel(int dimension) { return dimension == 2 ? 2 : 4; }

/// Whether any term of the facet is not zero.
bool is_loaded(const FacetLoads& loads, std::size_t facet, std::size_t dimension)
{
    const base::ReproducibleSum nothing;
    if (!loads.weight.empty() && !(loads.weight[facet] == nothing)) return true;
    if (loads.corner_force.empty()) return false;
    const auto* first = &loads.corner_force[4 * facet * dimension];
    return std::any_of(first, first + 4 * dimension, [&nothing](const auto& sum) { return !(sum == nothing); });
}

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

void write_loads(const FacetBatch& used, const FacetLoads& loads, int owner, PacketHeader& header, PacketWriter& packet)
{
    const auto dimension = static_cast<std::size_t>(used.dimension);
    const std::size_t corners = corners_that_travel(used.dimension);
    const bool any = !loads.corner_force.empty() || !loads.weight.empty();
    std::vector<std::size_t> loaded;
    for (std::size_t facet = 0; any && facet < used.facet_ids.size(); ++facet)
        if (used.facet_owner[facet] == owner && is_loaded(loads, facet, dimension)) loaded.push_back(facet);
    header.facets = static_cast<std::int64_t>(loaded.size());
    for (const std::size_t facet : loaded) packet.put(used.facet_ids[facet]);
    if (!loads.corner_force.empty()) {
        header.flags |= with_force;
        for (const std::size_t facet : loaded)
            packet.put(&loads.corner_force[4 * facet * dimension], corners * dimension);
    }
    if (!loads.weight.empty()) {
        header.flags |= with_pressure;
        for (const std::size_t facet : loaded) packet.put(loads.weight[facet]);
        for (const std::size_t facet : loaded) packet.put(loads.weighted_pressure[facet]);
        for (const std::size_t facet : loaded) packet.put(loads.full_weight[facet]);
    }
}

LoadSum::LoadSum(const WetSurface& surface, const std::vector<int>& order)
    : dimension_(surface.dimension),
      corners_(corners_that_travel(surface.dimension)),
      order_(order),
      facet_nodes_(surface.facet_nodes),
      force_(surface.reference.size()),
      weight_(surface.facet_ids.size()),
      weighted_pressure_(surface.facet_ids.size()),
      full_weight_(surface.facet_ids.size())
{
    for (const int facet : order) sorted_ids_.push_back(surface.facet_ids[static_cast<std::size_t>(facet)]);
}

void LoadSum::clear()
{
    std::fill(force_.begin(), force_.end(), base::ReproducibleSum());
    std::fill(weight_.begin(), weight_.end(), base::ReproducibleSum());
    std::fill(weighted_pressure_.begin(), weighted_pressure_.end(), base::ReproducibleSum());
    std::fill(full_weight_.begin(), full_weight_.end(), 0.0);
    has_force_ = has_pressure_ = false;
}

/// Index of the facet with this id; ids come in ascending order, so that the search goes on from the last one.
std::size_t LoadSum::find(std::int64_t id, std::size_t& hint, const std::string& who) const
{
    while (hint < sorted_ids_.size() && sorted_ids_[hint] < id) ++hint;
    base::require_input(hint < sorted_ids_.size() && sorted_ids_[hint] == id, who, " sent a load for wet facet ", id,
                        ", which is not one of the ", sorted_ids_.size(), " facets of this rank");
    return static_cast<std::size_t>(order_[hint]);
}

void LoadSum::add(PacketReader& packet, const std::string& who)
{
    const auto count = static_cast<std::size_t>(packet.header().facets);
    const auto dimension = static_cast<std::size_t>(dimension_);
    packet.take(ids_, count);
    if (packet.header().has(with_force)) {
        has_force_ = true;
        packet.take(sums_, count * corners_ * dimension);
        std::size_t hint = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const auto& nodes = facet_nodes_[find(ids_[k], hint, who)];
            for (std::size_t corner = 0; corner < corners_ && nodes[corner] >= 0; ++corner)
                for (std::size_t d = 0; d < dimension; ++d)
                    force_[static_cast<std::size_t>(nodes[corner]) * dimension + d] +=
                        sums_[(k * corners_ + corner) * dimension + d];
        }
    }
    if (!packet.header().has(with_pressure)) return;
    has_pressure_ = true;
    packet.take(sums_, count);
    packet.take(more_sums_, count);
    packet.take(numbers_, count);
    std::size_t hint = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t facet = find(ids_[k], hint, who);
        weight_[facet] += sums_[k];
        weighted_pressure_[facet] += more_sums_[k];
        full_weight_[facet] = std::max(full_weight_[facet], numbers_[k]);
    }
}

void LoadSum::write_force(std::vector<double>& force) const
{
    force.resize(force_.size());
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

std::uint64_t LoadSum::fingerprint() const
{
    const auto of = [](const auto& items) { return checksum(items.data(), items.size() * sizeof(items[0])); };
    const std::uint64_t parts[] = {of(force_), of(weight_), of(weighted_pressure_), of(full_weight_)};
    return checksum(parts, sizeof(parts));
}

} // namespace coupler

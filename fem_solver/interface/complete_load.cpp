// SPDX-License-Identifier: MIT
#include "fem_solver/interface/wet_boundary.hpp"

#include <map>

namespace fem {
namespace {

/// The values of all ranks, `width` numbers by the item's number in the whole surface; none where nobody has any.
/// \param add sums what several ranks have of one item, in rank order; else the first counts.
std::map<std::int64_t, std::vector<double>> collect(const Team& team, const std::vector<std::int64_t>& my_ids,
                                                    const std::vector<double>& mine, bool add)
{
    std::map<std::int64_t, std::vector<double>> all;
    const auto ids = team.gather_all(mine.empty() ? std::vector<std::int64_t>{} : my_ids);
    const auto values = team.gather_all(mine);
    const std::size_t width = ids.empty() ? 0 : values.size() / ids.size();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        auto [item, is_new] = all.try_emplace(ids[i], width, 0.0);
        if (is_new || add)
            for (std::size_t k = 0; k < width; ++k) item->second[k] += values[i * width + k];
    }
    return all;
}

/// The values of the wanted items, one after the other; nothing where nobody has any.
std::vector<double> pick(const std::map<std::int64_t, std::vector<double>>& all,
                         const std::vector<std::int64_t>& wanted)
{
    std::vector<double> values;
    if (all.empty()) return values;
    for (const std::int64_t id : wanted) values.insert(values.end(), all.at(id).begin(), all.at(id).end());
    return values;
}

} // namespace

coupler::SurfaceLoad WetBoundary::complete(const coupler::SurfaceLoad& own) const
{
    const Team& team = mesh_->team();
    if (team.size() == 1) return own;
    std::vector<std::int64_t> nodes, own_nodes, own_facets;
    for (const int node : nodes_) nodes.push_back(mesh_->node_id(node));
    for (const int node : own_nodes_) own_nodes.push_back(mesh_->node_id(node));
    for (const int facet : own_facets_) own_facets.push_back(facet_ids_[static_cast<std::size_t>(facet)]);
    return {own.impedance, pick(collect(team, own_nodes, own.force, true), nodes),
            pick(collect(team, own_facets, own.pressure, false), facet_ids_),
            pick(collect(team, own_nodes, own.wall_velocity, false), nodes)};
}

} // namespace fem

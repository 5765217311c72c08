// SPDX-License-Identifier: MIT
#include "sph_solver/parallel/partition.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <metis.h>
#include <numeric>
#include <utility>

namespace sph {
namespace {

std::vector<idx_t> to_metis(const std::vector<std::int64_t>& values) { return {values.begin(), values.end()}; }

/// METIS counts in 32 bits (idx_t of Debian's build): scale the work so that its sum stays far below 2^31.
std::vector<idx_t> scaled_weights(const std::vector<std::int64_t>& weights)
{
    const std::int64_t total = std::accumulate(weights.begin(), weights.end(), std::int64_t{0});
    const std::int64_t divisor = total / 1'000'000'000 + 1;
    std::vector<idx_t> scaled(weights.size());
    for (std::size_t v = 0; v < weights.size(); ++v) scaled[v] = static_cast<idx_t>(weights[v] / divisor + 1);
    return scaled;
}

std::vector<int> one_each(std::size_t count)
{
    std::vector<int> parts(count);
    std::iota(parts.begin(), parts.end(), 0);
    return parts;
}

} // namespace

std::vector<int> partition(const WeightedGraph& graph, int parts)
{
    if (parts == 1) return std::vector<int>(graph.size(), 0);
    if (graph.size() <= static_cast<std::size_t>(parts)) return one_each(graph.size());
    auto vertices = static_cast<idx_t>(graph.size());
    idx_t constraints = 1;
    idx_t part_count = parts;
    idx_t cut = 0;
    auto offsets = to_metis(graph.offsets);
    auto adjacency = to_metis(graph.adjacency);
    auto weights = scaled_weights(graph.vertex_weights);
    auto edges = to_metis(graph.edge_weights);
    std::array<idx_t, METIS_NOPTIONS> options{};
    METIS_SetDefaultOptions(options.data());
    options[METIS_OPTION_SEED] = 1;
    std::vector<idx_t> part(graph.size());
    const int status =
        METIS_PartGraphRecursive(&vertices, &constraints, offsets.data(), adjacency.data(), weights.data(), nullptr,
                                 edges.data(), &part_count, nullptr, nullptr, options.data(), &cut, part.data());
    base::require(status == METIS_OK, base::ExitCode::numerical_failure, "METIS could not cut a graph of ",
                  graph.size(), " blocks into ", parts, " parts (status ", status, ")");
    return {part.begin(), part.end()};
}

std::vector<int> keep_owners(std::vector<int> parts, const std::vector<int>& old_owners,
                             const std::vector<std::int64_t>& work, int part_count)
{
    std::map<std::pair<int, int>, std::int64_t> shared; // (part, owner)
    for (std::size_t v = 0; v < parts.size(); ++v)
        if (old_owners[v] >= 0) shared[{parts[v], old_owners[v]}] += work[v];
    std::vector<std::pair<std::int64_t, std::pair<int, int>>> matches;
    for (const auto& [who, amount] : shared) matches.push_back({-amount, who}); // most first
    std::sort(matches.begin(), matches.end());

    constexpr int none = -1;
    std::vector<int> number(static_cast<std::size_t>(part_count), none), taken_by(number);
    const auto match = [&](int part, int owner) {
        if (number[static_cast<std::size_t>(part)] != none || taken_by[static_cast<std::size_t>(owner)] != none) return;
        number[static_cast<std::size_t>(part)] = owner;
        taken_by[static_cast<std::size_t>(owner)] = part;
    };
    for (const auto& [amount, who] : matches) match(who.first, who.second);
    for (int part = 0, owner = 0; part < part_count; ++part)
        for (; number[static_cast<std::size_t>(part)] == none; ++owner) match(part, owner);
    for (int& part : parts) part = number[static_cast<std::size_t>(part)];
    return parts;
}

double imbalance(const std::vector<int>& parts, const std::vector<std::int64_t>& work, int part_count)
{
    std::vector<std::int64_t> sums(static_cast<std::size_t>(part_count), 0);
    std::int64_t total = 0;
    for (std::size_t v = 0; v < parts.size(); ++v) {
        sums[static_cast<std::size_t>(parts[v])] += work[v];
        total += work[v];
    }
    const auto largest = static_cast<double>(*std::max_element(sums.begin(), sums.end()));
    return total > 0 ? largest * part_count / static_cast<double>(total) : 1.0;
}

} // namespace sph

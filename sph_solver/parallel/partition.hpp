// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace sph {

/// A graph to be cut: vertex v has the work vertex_weights[v] and is joined to the vertices
/// adjacency[offsets[v] .. offsets[v+1]), symmetric, each edge with the cost of cutting it.
struct WeightedGraph {
    std::vector<std::int64_t> vertex_weights;
    std::vector<std::int64_t> offsets = {0};
    std::vector<std::int64_t> adjacency;
    std::vector<std::int64_t> edge_weights;

    [[nodiscard]] std::size_t size() const { return vertex_weights.size(); }
};

/// Cuts the graph in `parts` pieces of like work with few cut edges (METIS_PartGraphKway with a fixed seed, so that the
/// same graph always gives the same answer). Returns the part of each vertex; with fewer vertices than parts some
/// parts stay empty. Throws Error(numerical_failure) when METIS refuses.
std::vector<int> partition(const WeightedGraph& graph, int parts);

} // namespace sph

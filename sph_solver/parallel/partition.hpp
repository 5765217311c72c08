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

/// Cuts the graph in `parts` pieces of like work with few cut edges (METIS_PartGraphRecursive with a fixed seed, so that
/// the same graph always gives the same answer; on blocks of 3D water it has balanced better than METIS_PartGraphKway
/// and left less halo: docs/theory/parallel.md). Returns the part of each vertex; with fewer vertices than parts some
/// parts stay empty. Throws Error(numerical_failure) when METIS refuses.
std::vector<int> partition(const WeightedGraph& graph, int parts);

/// Gives the parts other numbers, so that as much work as possible keeps the owner that it had (`old_owners`, -1: none):
/// the part and the owner that share most are matched first. Which particles lie together does not change.
std::vector<int> keep_owners(std::vector<int> parts, const std::vector<int>& old_owners,
                             const std::vector<std::int64_t>& work, int part_count);

/// Largest work of a part over the mean [-].
double imbalance(const std::vector<int>& parts, const std::vector<std::int64_t>& work, int part_count);

} // namespace sph

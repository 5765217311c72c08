// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/partition.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <array>
#include <metis.h>

namespace fem {
namespace {

/// METIS allocates the graph with malloc.
struct DualGraph {
    idx_t* offsets = nullptr;
    idx_t* neighbours = nullptr;
    ~DualGraph()
    {
        METIS_Free(offsets);
        METIS_Free(neighbours);
    }
};

void require_metis(int status, const Mesh& mesh, const char* what)
{
    base::require(status == METIS_OK, base::ExitCode::numerical_failure, "METIS could not ", what, " a mesh of ",
                  mesh.elements(), " elements (status ", status, ")");
}

/// Corners that two elements share when they share a face.
idx_t corners_of_face(ElementType type)
{
    return with_shape(type, [](auto shape) {
        if constexpr (decltype(shape)::dimension == 2) return idx_t{2};
        return is_simplex<decltype(shape)> ? idx_t{3} : idx_t{4};
    });
}

void make_dual(const Mesh& mesh, DualGraph& graph)
{
    idx_t elements = mesh.elements(), nodes = mesh.nodes(), common = corners_of_face(mesh.type), base_number = 0;
    std::vector<idx_t> first(static_cast<std::size_t>(elements) + 1);
    for (std::size_t e = 0; e < first.size(); ++e) first[e] = static_cast<idx_t>(e) * mesh.nodes_per_element();
    std::vector<idx_t> connectivity(mesh.connectivity.begin(), mesh.connectivity.end());
    require_metis(METIS_MeshToDual(&elements, &nodes, first.data(), connectivity.data(), &common, &base_number,
                                   &graph.offsets, &graph.neighbours),
                  mesh, "find the neighbours in");
}

} // namespace

std::vector<int> element_work(const Mesh& mesh, const std::vector<std::string>& busy_groups)
{
    std::vector<int> work(static_cast<std::size_t>(mesh.elements()), 4);
    for (const std::string& group : busy_groups)
        for (const MeshFace& face : mesh.faces(group)) ++work[static_cast<std::size_t>(face.element)];
    return work;
}

std::vector<int> partition_elements(const Mesh& mesh, const std::vector<int>& work, int parts)
{
    if (parts == 1) return std::vector<int>(work.size(), 0);
    base::require_input(mesh.elements() >= parts, "the mesh has ", mesh.elements(), " elements, too few for ", parts,
                        " ranks: start the solid with -n ", mesh.elements(), " or less");
    DualGraph graph;
    make_dual(mesh, graph);
    idx_t elements = mesh.elements(), constraints = 1, count = parts, cut = 0;
    std::vector<idx_t> weights(work.begin(), work.end()), result(work.size());
    std::array<idx_t, METIS_NOPTIONS> options{};
    METIS_SetDefaultOptions(options.data());
    options[METIS_OPTION_SEED] = 1;
    require_metis(METIS_PartGraphRecursive(&elements, &constraints, graph.offsets, graph.neighbours, weights.data(),
                                           nullptr, nullptr, &count, nullptr, nullptr, options.data(), &cut,
                                           result.data()),
                  mesh, "cut");
    return {result.begin(), result.end()};
}

std::vector<int> partition_nodes(const Mesh& mesh, const std::vector<int>& element_ranks, int parts)
{
    const auto n = static_cast<std::size_t>(mesh.nodes_per_element());
    std::vector<std::vector<int>> around(static_cast<std::size_t>(mesh.nodes()));
    for (std::size_t i = 0; i < mesh.connectivity.size(); ++i) {
        auto& ranks = around[static_cast<std::size_t>(mesh.connectivity[i])];
        const int rank = element_ranks[i / n];
        if (std::ranges::find(ranks, rank) == ranks.end()) ranks.push_back(rank);
    }
    std::vector<int> owners(around.size(), 0), owned(static_cast<std::size_t>(parts), 0);
    const auto take = [&](std::size_t node) {
        const auto has_less = [&](int a, int b) {
            const int of_a = owned[static_cast<std::size_t>(a)], of_b = owned[static_cast<std::size_t>(b)];
            return of_a != of_b ? of_a < of_b : a < b;
        };
        owners[node] = *std::ranges::min_element(around[node], has_less);
        ++owned[static_cast<std::size_t>(owners[node])];
    };
    for (std::size_t node = 0; node < around.size(); ++node)
        if (around[node].size() == 1) take(node);
    for (std::size_t node = 0; node < around.size(); ++node)
        if (around[node].size() > 1) take(node);
    return owners;
}

} // namespace fem

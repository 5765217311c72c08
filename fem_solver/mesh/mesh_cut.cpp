// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/partition.hpp"

#include <algorithm>

namespace fem {
namespace {

/// The chosen items of a whole, own ones first, each in the order of the whole; and the way back.
struct Selection {
    std::vector<std::int64_t> ids;
    std::vector<int> local; ///< of each item of the whole, -1 where it is not chosen
    int own = 0;

    Selection(const std::vector<char>& chosen, const std::vector<int>& ranks, int rank) : local(chosen.size(), -1)
    {
        const auto add = [&](bool mine) {
            for (std::size_t i = 0; i < chosen.size(); ++i)
                if (chosen[i] != 0 && (ranks[i] == rank) == mine) {
                    local[i] = static_cast<int>(ids.size());
                    ids.push_back(static_cast<std::int64_t>(i));
                }
        };
        add(true);
        own = static_cast<int>(ids.size());
        add(false);
    }
};

class Cut {
public:
    Cut(const Mesh& whole, const std::vector<int>& element_ranks, const std::vector<int>& node_ranks, int rank)
        : whole_(whole),
          elements_(chosen_elements(element_ranks, node_ranks, rank), element_ranks, rank),
          nodes_(nodes_of_elements(), node_ranks, rank)
    {}

    Mesh mesh() const
    {
        Mesh mesh;
        mesh.type = whole_.type;
        mesh.dimension = whole_.dimension;
        for (const std::int64_t node : nodes_.ids)
            mesh.coordinates.insert(mesh.coordinates.end(), whole_.node(static_cast<int>(node)),
                                    whole_.node(static_cast<int>(node)) + whole_.dimension);
        for (const std::int64_t element : elements_.ids)
            for (const int* node = first(element); node != first(element + 1); ++node)
                mesh.connectivity.push_back(nodes_.local[static_cast<std::size_t>(*node)]);
        for (const auto& [name, faces] : whole_.face_groups) {
            auto& group = mesh.face_groups[name];
            for (const MeshFace& face : faces)
                if (const int e = elements_.local[static_cast<std::size_t>(face.element)]; e >= 0)
                    group.push_back({e, face.face});
        }
        for (const auto& [name, nodes] : whole_.node_groups) {
            auto& group = mesh.node_groups[name];
            for (const int node : nodes)
                if (const int i = nodes_.local[static_cast<std::size_t>(node)]; i >= 0) group.push_back(i);
            std::ranges::sort(group);
        }
        return mesh;
    }

    MeshPart part(const std::vector<int>& node_ranks, const base::Communicator& comm) const
    {
        MeshPart part{Team(comm), nodes_.own, elements_.own, nodes_.ids, elements_.ids, {}};
        for (const std::int64_t node : nodes_.ids) part.owners.push_back(node_ranks[static_cast<std::size_t>(node)]);
        return part;
    }

private:
    const int* first(std::int64_t element) const
    {
        return whole_.connectivity.data() + element * whole_.nodes_per_element();
    }

    std::vector<char> chosen_elements(const std::vector<int>& element_ranks, const std::vector<int>& node_ranks,
                                      int rank) const
    {
        std::vector<char> chosen(element_ranks.size(), 0);
        for (std::size_t e = 0; e < chosen.size(); ++e) {
            const int* nodes = first(static_cast<std::int64_t>(e));
            chosen[e] = element_ranks[e] == rank || std::any_of(nodes, nodes + whole_.nodes_per_element(), [&](int i) {
                            return node_ranks[static_cast<std::size_t>(i)] == rank;
                        });
        }
        return chosen;
    }

    std::vector<char> nodes_of_elements() const
    {
        std::vector<char> chosen(static_cast<std::size_t>(whole_.nodes()), 0);
        for (const std::int64_t element : elements_.ids)
            for (const int* node = first(element); node != first(element + 1); ++node)
                chosen[static_cast<std::size_t>(*node)] = 1;
        return chosen;
    }

    const Mesh& whole_;
    Selection elements_, nodes_;
};

} // namespace

Mesh cut_mesh(const Mesh& whole, const std::vector<int>& element_ranks, const std::vector<int>& node_ranks,
              const base::Communicator& comm)
{
    const Cut cut(whole, element_ranks, node_ranks, comm.rank());
    Mesh mesh = cut.mesh();
    mesh.part = std::make_shared<const MeshPart>(cut.part(node_ranks, comm));
    return mesh;
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/linear_facets.hpp"

namespace fem {

std::vector<std::array<int, 4>> linear_facets(const Mesh& mesh, const std::vector<MeshFace>& faces)
{
    std::vector<std::array<int, 4>> facets;
    with_shape(mesh.type, [&](auto shape) {
        for (const MeshFace& face : faces) {
            const auto nodes = mesh.face_nodes(face);
            for (const auto& part : decltype(shape)::Face::linear_parts) {
                std::array<int, 4> facet{-1, -1, -1, -1};
                for (std::size_t a = 0; a < part.size(); ++a) facet[a] = nodes[part[a]];
                facets.push_back(facet);
            }
        }
    });
    return facets;
}

} // namespace fem

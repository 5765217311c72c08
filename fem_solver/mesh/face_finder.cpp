// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/face_finder.hpp"

#include <algorithm>

namespace fem {

FaceFinder::FaceFinder(const Mesh& mesh)
{
    const int count = with_shape(mesh.type, [](auto shape) { return static_cast<int>(shape.faces.size()); });
    for (int element = 0; element < mesh.elements(); ++element)
        for (int f = 0; f < count; ++f) {
            std::vector<int> nodes = mesh.face_nodes({element, f});
            std::ranges::sort(nodes);
            faces_[std::move(nodes)].push_back({element, f});
        }
}

std::vector<MeshFace> FaceFinder::find(std::vector<int> nodes) const
{
    std::ranges::sort(nodes);
    const auto found = faces_.find(nodes);
    return found == faces_.end() ? std::vector<MeshFace>{} : found->second;
}

} // namespace fem

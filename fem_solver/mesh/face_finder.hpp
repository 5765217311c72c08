// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/mesh/mesh.hpp"

#include <map>
#include <vector>

namespace fem {

/// Finds the faces of a mesh by their nodes.
class FaceFinder {
public:
    explicit FaceFinder(const Mesh& mesh);

    /// Faces made of these nodes, in whatever order: one on the surface of the body, two between elements, else none.
    std::vector<MeshFace> find(std::vector<int> nodes) const;

private:
    std::map<std::vector<int>, std::vector<MeshFace>> faces_;
};

} // namespace fem

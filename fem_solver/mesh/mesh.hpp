// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/element_type.hpp"

#include <map>
#include <string>
#include <vector>

namespace fem {

/// A face (edge in 2D) of an element: row `face` of the element shape's table of faces.
struct MeshFace {
    int element;
    int face;
};

/// Nodes, elements of one type, and named groups of nodes and boundary faces.
struct Mesh {
    ElementType type = ElementType::quad8;
    int dimension = 2;
    std::vector<double> coordinates; ///< nodes * dimension, reference positions [m]
    std::vector<int> connectivity;   ///< elements * nodes per element
    std::map<std::string, std::vector<MeshFace>> face_groups;
    std::map<std::string, std::vector<int>> node_groups;

    int nodes() const { return static_cast<int>(coordinates.size()) / dimension; }
    int nodes_per_element() const;
    int elements() const { return static_cast<int>(connectivity.size()) / nodes_per_element(); }
    const double* node(int i) const { return coordinates.data() + static_cast<std::size_t>(i) * dimension; }

    /// Faces of a named group. \throws base::Error bad_input naming the group and those that exist.
    const std::vector<MeshFace>& faces(const std::string& group) const;
    /// Nodes of a named group, ascending. \throws base::Error bad_input naming the group and those that exist.
    const std::vector<int>& group_nodes(const std::string& group) const;
    /// Node ids of a face in the order of the face's shape.
    std::vector<int> face_nodes(const MeshFace& face) const;
    /// The node nearest to a point given by its `dimension` coordinates [m]; the lowest id wins a tie.
    int nearest_node(const std::vector<double>& point) const;
    /// Position of a node as text, "(0.1, 0.079)", for messages.
    std::string describe_node(int node) const;
};

/// \throws base::Error bad_input naming element and position where the Jacobian is not positive.
void check_jacobians(const Mesh& mesh);

} // namespace fem

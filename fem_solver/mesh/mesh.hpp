// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/element_type.hpp"
#include "fem_solver/mesh/team.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace fem {

/// A face (edge in 2D) of an element: row `face` of the element shape's table of faces.
struct MeshFace {
    int element;
    int face;
};

/// What a rank holds of a body that several ranks share: all elements around the nodes that it owns, so that forces and
/// matrix rows of its own nodes are complete without any exchange.
struct MeshPart {
    Team team;
    int own_nodes = 0, own_elements = 0;   ///< they come first; behind them is the halo, copies of other ranks' ones
    std::vector<std::int64_t> node_ids;    ///< number in the whole mesh, ascending among own nodes and in the halo
    std::vector<std::int64_t> element_ids; ///< likewise
    std::vector<int> owners;               ///< rank that owns each node
};

/// Nodes, elements of one type, and named groups of nodes and boundary faces: the whole body, or a rank's part of it.
/// Every part has all groups, some of them empty.
struct Mesh {
    ElementType type = ElementType::quad8;
    int dimension = 2;
    std::vector<double> coordinates; ///< nodes * dimension, reference positions [m]
    std::vector<int> connectivity;   ///< elements * nodes per element
    std::map<std::string, std::vector<MeshFace>> face_groups;
    std::map<std::string, std::vector<int>> node_groups;
    std::shared_ptr<const MeshPart> part; ///< null: the whole body is here

    int own_nodes() const { return part ? part->own_nodes : nodes(); }
    int own_elements() const { return part ? part->own_elements : elements(); }
    /// Number of a node or an element in the whole mesh.
    std::int64_t node_id(int i) const { return part ? part->node_ids[static_cast<std::size_t>(i)] : i; }
    std::int64_t element_id(int e) const { return part ? part->element_ids[static_cast<std::size_t>(e)] : e; }
    /// The ranks that share the body.
    const Team& team() const;

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
    /// The node nearest to a point given by its `dimension` coordinates [m]; the lowest id wins a tie. Collective: -1 on
    /// ranks that do not hold it.
    int nearest_node(const std::vector<double>& point) const;
    /// Position of a node as text, "(0.1, 0.079)", for messages.
    std::string describe_node(int node) const;
};

/// Elements and nodes of the whole body. Collective.
std::int64_t all_elements(const Mesh& mesh);
std::int64_t all_nodes(const Mesh& mesh);

/// The axis-parallel box around the whole undeformed body, `dimension` numbers each [m]. Collective.
struct Box {
    std::vector<double> low, high;

    double longest_side() const;
    double shortest_side() const;
};
Box bounding_box(const Mesh& mesh);

/// \throws base::Error bad_input naming element and position where the Jacobian is not positive.
void check_jacobians(const Mesh& mesh);

} // namespace fem

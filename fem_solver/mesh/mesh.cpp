// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/mesh.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/element/simplex_rules.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace fem {
namespace {

template<class Groups> const auto& find_group(const Groups& groups, const std::string& name)
{
    const auto found = groups.find(name);
    if (found != groups.end()) return found->second;
    std::string known;
    for (const auto& entry : groups) known += (known.empty() ? "" : ", ") + entry.first;
    throw base::Error(base::ExitCode::bad_input, "the mesh has no group '" + name + "'; its groups are: " + known);
}

template<class Shape>
Eigen::Matrix<double, Shape::dimension, Shape::nodes> element_positions(const Mesh& mesh, int element)
{
    Eigen::Matrix<double, Shape::dimension, Shape::nodes> x;
    for (int a = 0; a < Shape::nodes; ++a) {
        const double* node = mesh.node(mesh.connectivity[static_cast<std::size_t>(element) * Shape::nodes + a]);
        for (int k = 0; k < Shape::dimension; ++k) x(k, a) = node[k];
    }
    return x;
}

} // namespace

int Mesh::nodes_per_element() const
{
    return with_shape(type, [](auto shape) { return shape.nodes; });
}

const std::vector<MeshFace>& Mesh::faces(const std::string& group) const { return find_group(face_groups, group); }

const std::vector<int>& Mesh::group_nodes(const std::string& group) const { return find_group(node_groups, group); }

std::vector<int> Mesh::face_nodes(const MeshFace& face) const
{
    return with_shape(type, [&](auto shape) {
        std::vector<int> nodes;
        for (const int local : shape.faces[face.face])
            nodes.push_back(connectivity[static_cast<std::size_t>(face.element) * shape.nodes + local]);
        return nodes;
    });
}

const Team& Mesh::team() const
{
    static const Team alone;
    return part ? part->team : alone;
}

int Mesh::nearest_node(const std::vector<double>& point) const
{
    int best = -1;
    double best_distance = std::numeric_limits<double>::max();
    for (int i = 0; i < own_nodes(); ++i) {
        double distance = 0;
        for (int k = 0; k < dimension; ++k) distance += (node(i)[k] - point[k]) * (node(i)[k] - point[k]);
        if (distance < best_distance) {
            best = i;
            best_distance = distance;
        }
    }
    if (!part) return best;
    const bool tied = best_distance == team().min(best_distance);
    const auto none = std::numeric_limits<std::int64_t>::max();
    const std::int64_t id = -team().max(tied && best >= 0 ? -node_id(best) : -none);
    const auto found = std::ranges::find(part->node_ids, id);
    return found == part->node_ids.end() ? -1 : static_cast<int>(found - part->node_ids.begin());
}

std::string Mesh::describe_node(int i) const
{
    std::string text = "(";
    for (int k = 0; k < dimension; ++k) text += base::text(k > 0 ? ", " : "", node(i)[k]);
    return text + ")";
}

std::int64_t all_elements(const Mesh& mesh) { return mesh.team().sum(std::int64_t{mesh.own_elements()}); }
std::int64_t all_nodes(const Mesh& mesh) { return mesh.team().sum(std::int64_t{mesh.own_nodes()}); }

double Box::longest_side() const
{
    double side = 0;
    for (std::size_t k = 0; k < low.size(); ++k) side = std::max(side, high[k] - low[k]);
    return side;
}

double Box::shortest_side() const
{
    double side = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < low.size(); ++k) side = std::min(side, high[k] - low[k]);
    return side;
}

Box bounding_box(const Mesh& mesh)
{
    const auto d = static_cast<std::size_t>(mesh.dimension);
    Box box{std::vector<double>(d, std::numeric_limits<double>::max()),
            std::vector<double>(d, std::numeric_limits<double>::lowest())};
    for (int i = 0; i < mesh.own_nodes(); ++i)
        for (std::size_t k = 0; k < d; ++k) {
            box.low[k] = std::min(box.low[k], mesh.node(i)[k]);
            box.high[k] = std::max(box.high[k], mesh.node(i)[k]);
        }
    for (std::size_t k = 0; k < d; ++k) {
        box.low[k] = mesh.team().min(box.low[k]);
        box.high[k] = mesh.team().max(box.high[k]);
    }
    return box;
}

void check_jacobians(const Mesh& mesh)
{
    with_shape(mesh.type, [&](auto shape) {
        using Shape = decltype(shape);
        for (int e = 0; e < mesh.elements(); ++e) {
            const auto x = element_positions<Shape>(mesh, e);
            for (const auto& point : integration_points<Shape>(Shape::full_gauss)) {
                const double det = x.lazyProduct(Shape::gradients(point.xi).transpose()).eval().determinant();
                const int first = mesh.connectivity[static_cast<std::size_t>(e) * Shape::nodes];
                base::require_input(det > 0, "element ", e, " (", name_of(mesh.type), ") with its first node at ",
                                    mesh.describe_node(first), " m has the Jacobian ", det,
                                    ": it is turned inside out or has no volume");
            }
        }
    });
}

} // namespace fem

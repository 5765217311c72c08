// SPDX-License-Identifier: MIT
#include "fem_solver/contact/contact_points.hpp"

#include "fem_solver/assembly/face_integrals.hpp"

#include <cmath>
#include <map>

namespace fem {
namespace {

/// Calls `action(values, area)` at the integration points of a face.
template<class FaceShape, class Action>
void integrate(const Mesh& mesh, const std::vector<int>& nodes, const Eigen::VectorXd& displacement, Action&& action)
{
    const auto x = FaceIntegrals<FaceShape>::current(mesh, nodes.data(), displacement);
    for (const auto& point : face_points<FaceShape>())
        action(FaceShape::values(point.xi),
               point.weight * face_normal(FaceIntegrals<FaceShape>::tangents(x, point)).norm());
}

double length_of(double area, int dimension) { return dimension == 2 ? area : std::sqrt(area); }

template<class FaceShape>
std::vector<ContactPoint> integration_points_of(const Mesh& mesh, const std::vector<MeshFace>& faces)
{
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(std::ssize(mesh.coordinates));
    const std::vector<double> areas = face_areas(mesh, faces, still);
    std::vector<ContactPoint> points;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const std::vector<int> nodes = mesh.face_nodes(faces[f]);
        integrate<FaceShape>(mesh, nodes, still, [&](const auto& values, double area) {
            points.push_back({nodes,
                              {values.begin(), values.end()},
                              area,
                              length_of(areas[f], mesh.dimension),
                              {static_cast<int>(f)},
                              faces[f].element < mesh.own_elements()});
        });
    }
    return points;
}

/// The first node of a face whose function has an integral: the corners of flat six-node triangles have none.
template<class FaceShape> constexpr std::size_t first_with_area = std::is_same_v<FaceShape, Tri6> ? 3 : 0;

template<class FaceShape> std::vector<int> nodes_with_area(const std::vector<int>& nodes)
{
    return {nodes.begin() + first_with_area<FaceShape>, nodes.end()};
}

template<class FaceShape>
std::vector<ContactPoint> nodal_points_of(const Mesh& mesh, const std::vector<MeshFace>& faces)
{
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(std::ssize(mesh.coordinates));
    const std::vector<double> areas = face_areas(mesh, faces, still);
    std::map<int, ContactPoint> of_node;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const std::vector<int> nodes = mesh.face_nodes(faces[f]);
        integrate<FaceShape>(mesh, nodes, still, [&](const auto& values, double area) {
            for (std::size_t a = first_with_area<FaceShape>; a < nodes.size(); ++a)
                of_node[nodes[a]].area += values[static_cast<int>(a)] * area;
        });
        for (const int node : nodes_with_area<FaceShape>(nodes)) {
            ContactPoint& point = of_node[node];
            point.faces.push_back(static_cast<int>(f));
            point.size = std::max(point.size, length_of(areas[f], mesh.dimension));
        }
    }
    std::vector<ContactPoint> points;
    for (auto& [node, point] : of_node) {
        point.nodes = {node};
        point.values = {1.0};
        point.own = node < mesh.own_nodes();
        points.push_back(std::move(point));
    }
    return points;
}

} // namespace

std::vector<ContactPoint> contact_points(const Mesh& mesh, const std::vector<MeshFace>& faces)
{
    return with_shape(mesh.type, [&](auto shape) {
        using FaceShape = typename decltype(shape)::Face;
        if constexpr (std::is_same_v<FaceShape, Quad8>)
            return integration_points_of<FaceShape>(mesh, faces);
        else
            return nodal_points_of<FaceShape>(mesh, faces);
    });
}

std::vector<double> face_areas(const Mesh& mesh, const std::vector<MeshFace>& faces,
                               const Eigen::VectorXd& displacement)
{
    std::vector<double> areas;
    with_shape(mesh.type, [&](auto shape) {
        for (const MeshFace& face : faces) {
            areas.push_back(0);
            integrate<typename decltype(shape)::Face>(mesh, mesh.face_nodes(face), displacement,
                                                      [&](const auto&, double area) { areas.back() += area; });
        }
    });
    return areas;
}

double surface_stiffness(const std::vector<ContactPoint>& points, const Eigen::VectorXd& diagonal, const Mesh& mesh)
{
    const int dimension = mesh.dimension;
    double sum = 0, count = 0;
    for (const ContactPoint& point : points) {
        if (!point.own) continue;
        double largest = 0;
        for (const int node : point.nodes)
            largest =
                std::max(largest, diagonal.segment(static_cast<Eigen::Index>(node) * dimension, dimension).maxCoeff());
        sum += largest / point.area;
        ++count;
    }
    return mesh.team().sum(sum) / mesh.team().sum(count);
}

} // namespace fem

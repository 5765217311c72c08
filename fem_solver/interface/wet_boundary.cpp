// SPDX-License-Identifier: MIT
#include "fem_solver/interface/wet_boundary.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace fem {
namespace {

/// Nodes of facets, ascending.
std::vector<int> nodes_of(const std::vector<std::array<int, 4>>& facets)
{
    std::set<int> nodes;
    for (const auto& facet : facets)
        for (const int node : facet)
            if (node >= 0) nodes.insert(node);
    return {nodes.begin(), nodes.end()};
}

} // namespace

WetBoundary::WetBoundary(const Mesh& mesh, const std::vector<std::string>& groups) : mesh_(&mesh)
{
    base::require_input(!groups.empty(), "a coupled solid needs its wet faces: [interface] groups = [\"left\", ...]");
    std::vector<MeshFace> faces;
    for (const std::string& group : groups)
        for (const MeshFace& face : mesh.faces(group)) {
            const auto same = [&](const MeshFace& f) { return f.element == face.element && f.face == face.face; };
            if (std::ranges::none_of(faces, same)) faces.push_back(face);
        }
    facets_ = linear_facets(mesh, faces);
    nodes_ = nodes_of(facets_);
    number_facets(faces);
    std::vector<std::array<int, 4>> own;
    for (const int f : own_facets_) own.push_back(facets_[static_cast<std::size_t>(f)]);
    own_nodes_ = nodes_of(own);
}

/// Facets are numbered by element, face and part, over all ranks.
void WetBoundary::number_facets(const std::vector<MeshFace>& faces)
{
    constexpr std::int64_t most = 16; // faces of an element, and parts of a face
    const std::size_t parts = faces.empty() ? 1 : facets_.size() / faces.size();
    std::vector<std::int64_t> keys, own_keys;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        const MeshFace& face = faces[f / parts];
        keys.push_back((mesh_->element_id(face.element) * most + face.face) * most +
                       static_cast<std::int64_t>(f % parts));
        if (face.element >= mesh_->own_elements()) continue;
        own_facets_.push_back(static_cast<int>(f));
        own_keys.push_back(keys.back());
    }
    auto all = mesh_->team().gather_all(own_keys);
    std::ranges::sort(all);
    for (const std::int64_t key : keys) facet_ids_.push_back(std::ranges::lower_bound(all, key) - all.begin());
}

coupler::WetSurface WetBoundary::surface() const
{
    coupler::WetSurface surface;
    surface.dimension = mesh_->dimension;
    for (const int node : own_nodes_) {
        surface.node_ids.push_back(mesh_->node_id(node));
        surface.reference.insert(surface.reference.end(), mesh_->node(node), mesh_->node(node) + mesh_->dimension);
    }
    for (const int f : own_facets_) {
        const auto& facet = facets_[static_cast<std::size_t>(f)];
        std::array<int, 4> local{-1, -1, -1, -1};
        for (int a = 0; a < 4; ++a)
            if (facet[a] >= 0)
                local[a] = static_cast<int>(std::ranges::lower_bound(own_nodes_, facet[a]) - own_nodes_.begin());
        surface.facet_ids.push_back(facet_ids_[static_cast<std::size_t>(f)]);
        surface.facet_nodes.push_back(local);
    }
    return surface;
}

coupler::SurfaceMotion WetBoundary::motion(const Motion& motion) const
{
    const Eigen::Map<const Eigen::VectorXd> reference(mesh_->coordinates.data(), std::ssize(mesh_->coordinates));
    return {gather(reference + motion.displacement, own_nodes_), gather(motion.velocity, own_nodes_),
            gather(motion.acceleration, own_nodes_)};
}

Eigen::VectorXd WetBoundary::spread(const std::vector<double>& surface_values) const
{
    const int d = mesh_->dimension;
    Eigen::VectorXd field = Eigen::VectorXd::Zero(std::ssize(mesh_->coordinates));
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        for (int k = 0; k < d; ++k) field[nodes_[i] * d + k] = surface_values[i * d + k];
    return field;
}

std::vector<double> WetBoundary::gather(const Eigen::VectorXd& field) const { return gather(field, nodes_); }

std::vector<double> WetBoundary::gather(const Eigen::VectorXd& field, const std::vector<int>& nodes) const
{
    const int d = mesh_->dimension;
    std::vector<double> values;
    values.reserve(nodes.size() * d);
    for (const int node : nodes)
        for (int k = 0; k < d; ++k) values.push_back(field[node * d + k]);
    return values;
}

double WetBoundary::largest_displacement(const Motion& motion) const
{
    const int d = mesh_->dimension;
    double largest = 0;
    for (const int node : nodes_)
        largest = std::max(largest, motion.displacement.segment(static_cast<Eigen::Index>(node) * d, d).norm());
    return mesh_->team().max(largest);
}

Resultants resultants(const Mesh& mesh, const Motion& motion, const Eigen::VectorXd& forces)
{
    Resultants sum;
    const int d = mesh.dimension;
    for (int i = 0; i < mesh.own_nodes(); ++i) {
        std::array<double, 3> x{}, f{};
        for (int k = 0; k < d; ++k) {
            x[k] = mesh.node(i)[k] + motion.displacement[i * d + k];
            f[k] = forces[i * d + k];
            sum.force[k] += f[k];
        }
        for (int k = 0; k < 3; ++k) sum.moment[k] += x[(k + 1) % 3] * f[(k + 2) % 3] - x[(k + 2) % 3] * f[(k + 1) % 3];
    }
    mesh.team().sum(sum.force.data(), 3);
    mesh.team().sum(sum.moment.data(), 3);
    return sum;
}

} // namespace fem

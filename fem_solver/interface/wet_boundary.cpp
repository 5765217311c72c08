// SPDX-License-Identifier: MIT
#include "fem_solver/interface/wet_boundary.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace fem {

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
    std::set<int> nodes;
    for (const auto& facet : facets_)
        for (const int node : facet)
            if (node >= 0) nodes.insert(node);
    nodes_.assign(nodes.begin(), nodes.end());
}

coupler::WetSurface WetBoundary::surface() const
{
    coupler::WetSurface surface;
    surface.dimension = mesh_->dimension;
    for (const int node : nodes_) {
        surface.node_ids.push_back(node);
        surface.reference.insert(surface.reference.end(), mesh_->node(node), mesh_->node(node) + mesh_->dimension);
    }
    for (const auto& facet : facets_) {
        std::array<int, 4> local{-1, -1, -1, -1};
        for (int a = 0; a < 4; ++a)
            if (facet[a] >= 0) local[a] = static_cast<int>(std::ranges::lower_bound(nodes_, facet[a]) - nodes_.begin());
        surface.facet_ids.push_back(std::ssize(surface.facet_ids));
        surface.facet_nodes.push_back(local);
    }
    return surface;
}

coupler::SurfaceMotion WetBoundary::motion(const Motion& motion) const
{
    const Eigen::Map<const Eigen::VectorXd> reference(mesh_->coordinates.data(), std::ssize(mesh_->coordinates));
    return {gather(reference + motion.displacement), gather(motion.velocity), gather(motion.acceleration)};
}

Eigen::VectorXd WetBoundary::spread(const std::vector<double>& surface_values) const
{
    const int d = mesh_->dimension;
    Eigen::VectorXd field = Eigen::VectorXd::Zero(std::ssize(mesh_->coordinates));
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        for (int k = 0; k < d; ++k) field[nodes_[i] * d + k] = surface_values[i * d + k];
    return field;
}

std::vector<double> WetBoundary::gather(const Eigen::VectorXd& field) const
{
    const int d = mesh_->dimension;
    std::vector<double> values;
    values.reserve(nodes_.size() * d);
    for (const int node : nodes_)
        for (int k = 0; k < d; ++k) values.push_back(field[node * d + k]);
    return values;
}

double WetBoundary::largest_displacement(const Motion& motion) const
{
    const int d = mesh_->dimension;
    double largest = 0;
    for (const int node : nodes_)
        largest = std::max(largest, motion.displacement.segment(static_cast<Eigen::Index>(node) * d, d).norm());
    return largest;
}

Resultants resultants(const Mesh& mesh, const Motion& motion, const Eigen::VectorXd& forces)
{
    Resultants sum;
    const int d = mesh.dimension;
    for (int i = 0; i < mesh.nodes(); ++i) {
        std::array<double, 3> x{}, f{};
        for (int k = 0; k < d; ++k) {
            x[k] = mesh.node(i)[k] + motion.displacement[i * d + k];
            f[k] = forces[i * d + k];
            sum.force[k] += f[k];
        }
        for (int k = 0; k < 3; ++k) sum.moment[k] += x[(k + 1) % 3] * f[(k + 2) % 3] - x[(k + 2) % 3] * f[(k + 1) % 3];
    }
    return sum;
}

} // namespace fem

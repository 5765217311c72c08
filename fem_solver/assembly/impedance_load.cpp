// SPDX-License-Identifier: MIT
#include "fem_solver/assembly/impedance_load.hpp"

#include <Eigen/Geometry>

namespace fem {

ImpedanceLoad::ImpedanceLoad(const Mesh& mesh, const MatrixPattern& pattern, std::vector<std::array<int, 4>> facets)
    : mesh_(&mesh),
      pattern_(&pattern),
      facets_(std::move(facets)),
      slots_(mesh.nodes(), -1),
      reference_velocity_(Eigen::VectorXd::Zero(std::ssize(mesh.coordinates)))
{
    for (const auto& facet : facets_)
        for (const int node : facet)
            if (node >= 0 && slots_[node] < 0) {
                slots_[node] = static_cast<int>(nodes_.size());
                nodes_.push_back(node);
            }
    blocks_.assign(nodes_.size(), Eigen::Matrix3d::Zero());
}

void ImpedanceLoad::set(double impedance, const std::vector<char>& wet, const Eigen::VectorXd& displacement,
                        Eigen::VectorXd reference_velocity)
{
    reference_velocity_ = std::move(reference_velocity);
    std::fill(blocks_.begin(), blocks_.end(), Eigen::Matrix3d::Zero());
    for (std::size_t f = 0; f < facets_.size(); ++f)
        if (wet[f]) add_facet(facets_[f], impedance, displacement);
}

void ImpedanceLoad::add_facet(const std::array<int, 4>& facet, double impedance, const Eigen::VectorXd& displacement)
{
    const int d = mesh_->dimension;
    const auto position = [&](int node) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        for (int k = 0; k < d; ++k) x[k] = mesh_->node(node)[k] + displacement[node * d + k];
        return x;
    };
    int count = 2;
    Eigen::Vector3d area; // normal times area
    if (d == 2) {
        const Eigen::Vector3d t = position(facet[1]) - position(facet[0]);
        area = {t[1], -t[0], 0};
    } else {
        count = facet[3] < 0 ? 3 : 4;
        const Eigen::Vector3d a = position(facet[2]) - position(facet[0]);
        const Eigen::Vector3d b = position(facet[count - 1]) - position(facet[1]);
        area = 0.5 * (count == 4 ? a.cross(b) : Eigen::Vector3d(a.cross(position(facet[1]) - position(facet[0])) * -1));
    }
    const double size = area.norm();
    if (size == 0) return;
    const Eigen::Matrix3d block = impedance / (count * size) * area * area.transpose();
    for (int a = 0; a < count; ++a) blocks_[slots_[facet[a]]] += block;
}

void ImpedanceLoad::add_force(const Motion& motion, double scale, Eigen::VectorXd& force) const
{
    const int d = mesh_->dimension;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Eigen::Index at = static_cast<Eigen::Index>(nodes_[i]) * d;
        const Eigen::VectorXd change = motion.velocity.segment(at, d) - reference_velocity_.segment(at, d);
        force.segment(at, d) -= scale * blocks_[i].topLeftCorner(d, d) * change;
    }
}

void ImpedanceLoad::add_tangent(const Motion&, double scale, double velocity_slope, Matrix& matrix) const
{
    const int d = mesh_->dimension;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        pattern_->add_block(matrix, nodes_[i], nodes_[i], scale * velocity_slope * blocks_[i].topLeftCorner(d, d));
}

} // namespace fem

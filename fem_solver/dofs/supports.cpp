// SPDX-License-Identifier: MIT
#include "fem_solver/dofs/supports.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace fem {

std::vector<int> Supports::hold(const std::string& group, const std::string& component)
{
    const std::string names = mesh_->dimension == 2 ? "xy" : "xyz";
    const auto k = component.size() == 1 ? names.find(component) : std::string::npos;
    base::require_input(k != std::string::npos, "support of group '", group, "': '", component,
                        "' is no direction of a ", mesh_->dimension, "D model");
    if (std::ranges::count(groups_, group) == 0) groups_.push_back(group);
    const int owner = static_cast<int>(std::ranges::find(groups_, group) - groups_.begin());
    std::vector<int> dofs;
    for (const int node : mesh_->group_nodes(group)) {
        dofs.push_back(node * mesh_->dimension + static_cast<int>(k));
        fixed_[dofs.back()] = 1;
        if (owner_[dofs.back()] < 0) owner_[dofs.back()] = owner;
    }
    return dofs;
}

void Supports::fix(const std::string& group, const std::vector<std::string>& components)
{
    base::require_input(!components.empty(), "support of group '", group, "': fix is empty; give e.g. [\"x\", \"y\"]");
    for (const std::string& component : components) hold(group, component);
}

void Supports::fix_normal(const std::string& group)
{
    const int d = mesh_->dimension;
    Eigen::VectorXd low = Eigen::VectorXd::Constant(d, std::numeric_limits<double>::max()), high = -low;
    for (const MeshFace& face : mesh_->faces(group))
        for (const int node : mesh_->face_nodes(face)) {
            const Eigen::Map<const Eigen::VectorXd> x(mesh_->node(node), d);
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
    for (double& x : low) x = mesh_->team().min(x);
    for (double& x : high) x = mesh_->team().max(x);
    Eigen::Index normal = 0;
    const Eigen::VectorXd extent = high - low;
    const bool flat = extent.minCoeff(&normal) <= 1e-9 * extent.maxCoeff();
    base::require_input(flat, "support of group '", group, "': a plane of symmetry lies across x, y or z, but this ",
                        "group extends along all of them, over ", extent[normal], " m or more. Turn the mesh, or fix ",
                        "components");
    hold(group, std::string(1, "xyz"[normal]));
}

void Supports::prescribe(const std::string& group, const std::string& component, const Path& path)
{
    moves_ = true;
    for (const int dof : hold(group, component)) moved_.push_back({dof, path(mesh_->node(dof / mesh_->dimension))});
}

void Supports::drive(const std::string& group, std::shared_ptr<const RigidDrive> drive)
{
    for (int k = 0; k < mesh_->dimension; ++k)
        prescribe(group, std::string(1, "xyz"[k]), [&](const double* x) -> base::TimeFunction {
            const Eigen::Vector3d reference(x[0], x[1], mesh_->dimension == 3 ? x[2] : 0);
            return [=](double t) { return drive->displacement(reference, k, t); };
        });
    driven_.push_back({group, std::move(drive)});
}

void Supports::set_motion(double time, Motion& motion) const
{
    for (const Moved& moved : moved_) {
        const base::TimeValue now = moved.at(time);
        motion.displacement[moved.dof] = now.value;
        motion.velocity[moved.dof] = now.rate;
        motion.acceleration[moved.dof] = now.acceleration;
    }
}

Eigen::VectorXd Supports::gap(double time, const Eigen::VectorXd& displacement) const
{
    Eigen::VectorXd gap = Eigen::VectorXd::Zero(displacement.size());
    for (const Moved& moved : moved_) gap[moved.dof] = moved.at(time).value - displacement[moved.dof];
    return gap;
}

void Supports::clear_rows(Eigen::VectorXd& vector) const
{
    for (Eigen::Index i = 0; i < vector.size(); ++i)
        if (fixed_[i]) vector[i] = 0;
}

void Supports::clear(Matrix& matrix, double diagonal) const
{
    for (int j = 0; j < matrix.outerSize(); ++j)
        for (Matrix::InnerIterator entry(matrix, j); entry; ++entry)
            if (fixed_[entry.row()] || fixed_[j]) entry.valueRef() = entry.row() == j ? diagonal : 0;
}

Eigen::VectorXd Supports::held_part(const Eigen::VectorXd& forces) const
{
    Eigen::VectorXd held = forces;
    for (Eigen::Index i = 0; i < held.size(); ++i)
        if (!fixed_[i]) held[i] = 0;
    return held;
}

std::vector<double> Supports::reaction(const std::string& group, const Eigen::VectorXd& forces) const
{
    const int d = mesh_->dimension;
    std::vector<double> sum(d, 0.0);
    for (const int node : mesh_->group_nodes(group)) {
        if (node >= mesh_->own_nodes()) continue;
        for (int k = 0; k < d; ++k)
            if (fixed_[node * d + k]) sum[k] += forces[node * d + k];
    }
    return mesh_->team().sum(std::move(sum));
}

Eigen::Vector3d Supports::moment(const Driven& driven, double time, const Motion& motion,
                                 const Eigen::VectorXd& forces) const
{
    const int d = mesh_->dimension;
    const Eigen::Vector3d centre = driven.drive->centre(time);
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const int node : mesh_->group_nodes(driven.group)) {
        if (node >= mesh_->own_nodes()) continue;
        Eigen::Vector3d arm = -centre, force = Eigen::Vector3d::Zero();
        for (int k = 0; k < d; ++k) {
            arm[k] += mesh_->node(node)[k] + motion.displacement[node * d + k];
            force[k] = forces[node * d + k];
        }
        moment += arm.cross(force);
    }
    mesh_->team().sum(moment.data(), 3);
    return moment;
}

std::vector<double> Supports::sums(const Eigen::VectorXd& vector) const
{
    std::vector<double> sums(groups_.size(), 0.0);
    const int own = mesh_->own_nodes() * mesh_->dimension;
    for (int i = 0; i < own; ++i)
        if (owner_[i] >= 0) sums[owner_[i]] += vector[i];
    return mesh_->team().sum(std::move(sums));
}

} // namespace fem

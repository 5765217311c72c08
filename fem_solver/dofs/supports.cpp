// SPDX-License-Identifier: MIT
#include "fem_solver/dofs/supports.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>

namespace fem {

std::vector<int> Supports::hold(const std::string& group, const std::string& component)
{
    const std::string names = mesh_->dimension == 2 ? "xy" : "xyz";
    const auto k = component.size() == 1 ? names.find(component) : std::string::npos;
    base::require_input(k != std::string::npos, "support of group '", group, "': '", component,
                        "' is no direction of a ", mesh_->dimension, "D model");
    std::vector<int> dofs;
    for (const int node : mesh_->group_nodes(group)) {
        dofs.push_back(node * mesh_->dimension + static_cast<int>(k));
        fixed_[dofs.back()] = 1;
    }
    if (std::ranges::count(groups_, group) == 0) groups_.push_back(group);
    return dofs;
}

void Supports::fix(const std::string& group, const std::vector<std::string>& components)
{
    base::require_input(!components.empty(), "support of group '", group, "': fix is empty; give e.g. [\"x\", \"y\"]");
    for (const std::string& component : components) hold(group, component);
}

void Supports::prescribe(const std::string& group, const std::string& component, const Path& path)
{
    for (const int dof : hold(group, component)) moved_.push_back({dof, path(mesh_->node(dof / mesh_->dimension))});
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
    for (const int node : mesh_->group_nodes(group))
        for (int k = 0; k < d; ++k)
            if (fixed_[node * d + k]) sum[k] += forces[node * d + k];
    return sum;
}

} // namespace fem

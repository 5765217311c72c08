// SPDX-License-Identifier: MIT
#include "fem_solver/setup/make_load.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/assembly/pressure_load.hpp"
#include "fem_solver/assembly/surface_traction.hpp"

#include <algorithm>

namespace fem {
namespace {

PressureField pressure_field(const LoadConfig& load, int dimension)
{
    if (load.distribution == "uniform") {
        auto formula = std::make_shared<base::Expression>(load.pressure, std::vector<std::string>{"x", "y", "z"});
        return [=](const double* x) { return (*formula)({x[0], x[1], dimension == 3 ? x[2] : 0.0}); };
    }
    return [=](const double* x) { return load.density * load.gravity * std::max(load.level - x[dimension - 1], 0.0); };
}

std::vector<int> nodes_of(const LoadConfig& load, const Mesh& mesh)
{
    if (!load.group.empty()) return mesh.group_nodes(load.group);
    const int node = mesh.nearest_node(load.position);
    return node < 0 ? std::vector<int>{} : std::vector<int>{node};
}

std::unique_ptr<Load> nodal_force(const LoadConfig& load, const Mesh& mesh)
{
    Eigen::VectorXd force = Eigen::VectorXd::Zero(std::ssize(mesh.coordinates));
    for (const int node : nodes_of(load, mesh))
        for (int k = 0; k < mesh.dimension; ++k) force[node * mesh.dimension + k] = load.force[k];
    return std::make_unique<DeadLoad>(force);
}

std::unique_ptr<Load> springs(const LoadConfig& load, const Mesh& mesh, const MatrixPattern& pattern)
{
    if (!load.group.empty())
        return std::make_unique<Springs>(spring_stiffness(mesh, pattern, mesh.faces(load.group), load.stiffness));
    Matrix stiffness = pattern.zero();
    for (const int node : nodes_of(load, mesh))
        for (int k = 0; k < mesh.dimension; ++k) {
            const int dof = node * mesh.dimension + k;
            pattern.add_entry(stiffness, dof, dof, load.stiffness[k]);
        }
    return std::make_unique<Springs>(stiffness);
}

} // namespace

std::unique_ptr<Load> make_load(const LoadConfig& load, const Mesh& mesh, const MatrixPattern& pattern)
{
    if (load.kind == "nodal_force") return nodal_force(load, mesh);
    if (load.kind == "spring") return springs(load, mesh, pattern);
    const auto& faces = mesh.faces(load.group);
    if (load.kind == "traction") return std::make_unique<DeadLoad>(traction_force(mesh, faces, load.traction));
    if (load.kind == "follower_traction") return make_follower_traction(mesh, pattern, faces, load.traction);
    const PressureField pressure = pressure_field(load, mesh.dimension);
    if (load.follower) return make_follower_pressure(mesh, pattern, faces, pressure);
    return std::make_unique<DeadLoad>(dead_pressure_force(mesh, pattern, faces, pressure));
}

std::function<double(double)> function_of_time(const base::Formula& formula)
{
    auto expression = std::make_shared<base::Expression>(formula, std::vector<std::string>{"t"});
    return [expression](double t) {
        try {
            return (*expression)({t});
        } catch (const base::Error& error) { // no value at this t: the run fails, the file was read long ago
            throw base::Error(base::ExitCode::numerical_failure, error.what());
        }
    };
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/setup/solver_settings.hpp"

#include <map>

namespace fem {

SolverSettings solver_settings(const LinearSolverConfig& config)
{
    using Method = SolverSettings::Method;
    using Petsc = PetscSettings::Method;
    static const std::map<std::string, std::pair<Method, Petsc>> methods{
        {"automatic", {Method::automatic, Petsc::mumps}}, {"banded", {Method::banded, Petsc::mumps}},
        {"sparse", {Method::sparse, Petsc::mumps}},       {"mumps", {Method::petsc, Petsc::mumps}},
        {"gamg", {Method::petsc, Petsc::gmres_gamg}},     {"hypre", {Method::petsc, Petsc::gmres_hypre}}};
    const auto& [method, petsc] = methods.at(config.method);
    return {method, {petsc, config.tolerance, config.options}};
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/solve/make_linear_solver.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/solve/band_solver.hpp"
#include "fem_solver/solve/sparse_solver.hpp"

namespace fem {
namespace {

using Method = SolverSettings::Method;

/// Multiplications of a banded elimination, n w^2, up to which it is taken: about a second.
constexpr double band_work_limit = 1e9;

bool slender(const Matrix& pattern)
{
    const double width = BandSolver::width(pattern);
    return static_cast<double>(pattern.rows()) * width * width <= band_work_limit;
}

/// What `automatic` stands for.
Method chosen(Method asked, const DofMap& dofs, const Matrix& pattern)
{
    if (asked != Method::automatic) return asked;
    return dofs.team().size() == 1 && slender(pattern) ? Method::banded : Method::petsc;
}

} // namespace

std::unique_ptr<LinearSolver> make_linear_solver(const SolverSettings& settings, const Mesh& mesh, const DofMap& dofs,
                                                 const Matrix& pattern)
{
    const Method method = chosen(settings.method, dofs, pattern);
    base::require_input(dofs.team().size() == 1 || method == Method::petsc,
                        "[linear_solver] method = \"banded\" and \"sparse\" run on one rank, not on ",
                        dofs.team().size(), "; \"mumps\", \"gamg\" and \"hypre\" run on several");
    if (method == Method::banded) return std::make_unique<BandSolver>();
    if (method == Method::sparse) return std::make_unique<SparseSolver>();
    return std::make_unique<PetscSolver>(settings.petsc, mesh, dofs);
}

std::unique_ptr<LinearSolver> make_mass_solver(const SolverSettings& settings, const Mesh& mesh, const DofMap& dofs,
                                               const Matrix& pattern)
{
    if (chosen(settings.method, dofs, pattern) == Method::banded) return std::make_unique<BandSolver>();
    return std::make_unique<PetscSolver>(PetscSettings{PetscSettings::Method::cg_jacobi, 1e-13, ""}, mesh, dofs);
}

} // namespace fem

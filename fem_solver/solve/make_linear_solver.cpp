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

} // namespace

std::unique_ptr<LinearSolver> make_linear_solver(const SolverSettings& settings, const Mesh& mesh, const DofMap& dofs,
                                                 const Matrix& pattern)
{
    const bool alone = dofs.team().size() == 1;
    Method method = settings.method;
    base::require_input(alone || method == Method::automatic || method == Method::petsc,
                        "[linear_solver] method = \"banded\" and \"sparse\" run on one rank, not on ",
                        dofs.team().size(), "; \"mumps\", \"gamg\" and \"hypre\" run on several");
    if (method == Method::automatic) method = alone && slender(pattern) ? Method::banded : Method::petsc;
    if (method == Method::banded) return std::make_unique<BandSolver>();
    if (method == Method::sparse) return std::make_unique<SparseSolver>();
    return std::make_unique<PetscSolver>(settings.petsc, mesh, dofs);
}

std::unique_ptr<LinearSolver> make_mass_solver(const SolverSettings& settings, const Mesh& mesh, const DofMap& dofs,
                                               const Matrix& pattern)
{
    const bool banded = settings.method == Method::banded ||
                        (settings.method == Method::automatic && dofs.team().size() == 1 && slender(pattern));
    if (banded) return std::make_unique<BandSolver>();
    return std::make_unique<PetscSolver>(PetscSettings{PetscSettings::Method::cg_jacobi, 1e-13, ""}, mesh, dofs);
}

} // namespace fem

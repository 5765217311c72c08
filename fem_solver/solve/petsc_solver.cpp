// SPDX-License-Identifier: MIT
#include "fem_solver/solve/petsc_solver.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/solve/petsc_session.hpp"

namespace fem {
namespace {

constexpr const char* prefix = "solver_";

void add_options(const std::string& options)
{
    base::require_input(PetscOptionsInsertString(nullptr, options.c_str()) == 0, "[linear_solver] options = \"",
                        options,
                        "\": PETSc cannot read them; write them as on its command line, \"-solver_ksp_monitor\"");
}

} // namespace

PetscSolver::PetscSolver(const PetscSettings& settings, const Mesh& mesh, const DofMap& dofs)
    : settings_(settings), mesh_(&mesh), dofs_(&dofs)
{
    start_petsc(petsc_comm(dofs));
    add_options(settings.options);
}

PetscSolver::~PetscSolver()
{
    KSPDestroy(&solver_);
    VecDestroy(&right_hand_side_);
    VecDestroy(&solution_);
}

void PetscSolver::make_solver()
{
    MatCreateVecs(matrix_->handle(), &solution_, &right_hand_side_);
    require_petsc(KSPCreate(petsc_comm(*dofs_), &solver_), "make a solver");
    PC preconditioner = nullptr;
    KSPGetPC(solver_, &preconditioner);
    if (settings_.method == PetscSettings::Method::mumps) {
        KSPSetType(solver_, KSPPREONLY);
        PCSetType(preconditioner, PCLU);
        PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS);
    } else {
        KSPSetTolerances(solver_, settings_.tolerance, PETSC_DEFAULT, PETSC_DEFAULT, 1000);
        settings_.method == PetscSettings::Method::cg_jacobi ? choose_conjugate_gradients() : choose_multigrid();
    }
    KSPSetOptionsPrefix(solver_, prefix);
    require_petsc(KSPSetFromOptions(solver_), "take its options ([linear_solver] options)");
}

void PetscSolver::choose_conjugate_gradients()
{
    PC preconditioner = nullptr;
    KSPGetPC(solver_, &preconditioner);
    KSPSetType(solver_, KSPCG);
    KSPSetNormType(solver_, KSP_NORM_UNPRECONDITIONED);
    PCSetType(preconditioner, PCJACOBI);
}

void PetscSolver::choose_multigrid()
{
    const bool gamg = settings_.method == PetscSettings::Method::gmres_gamg;
    PC preconditioner = nullptr;
    KSPGetPC(solver_, &preconditioner);
    KSPSetType(solver_, KSPGMRES);
    KSPSetPCSide(solver_, PC_RIGHT); // so that the true residual is judged
    KSPGMRESSetRestart(solver_, 100);
    PCSetType(preconditioner, gamg ? PCGAMG : PCHYPRE);
    if (gamg) give_rigid_motions();
}

/// Multigrid must carry what costs no energy to its coarse levels: translations and small turns.
void PetscSolver::give_rigid_motions()
{
    Vec positions = nullptr;
    VecDuplicate(solution_, &positions);
    VecSetBlockSize(positions, mesh_->dimension);
    double* values = nullptr;
    VecGetArray(positions, &values);
    std::copy_n(mesh_->coordinates.data(), dofs_->own(), values);
    VecRestoreArray(positions, &values);
    MatNullSpace motions = nullptr;
    require_petsc(MatNullSpaceCreateRigidBody(positions, &motions), "make the rigid motions");
    MatSetNearNullSpace(matrix_->handle(), motions);
    MatNullSpaceDestroy(&motions);
    VecDestroy(&positions);
}

void PetscSolver::eliminate(const Matrix& matrix)
{
    if (!matrix_) matrix_.emplace(*mesh_, *dofs_, matrix);
    matrix_->set(matrix);
    if (!solver_) make_solver();
    KSPSetOperators(solver_, matrix_->handle(), matrix_->handle());
    require_petsc(KSPSetUp(solver_), "set up its solver");
    PC preconditioner = nullptr;
    KSPGetPC(solver_, &preconditioner);
    PCFailedReason failed = PC_NOERROR;
    PCGetFailedReason(preconditioner, &failed);
    base::require(!dofs_->team().any(failed != PC_NOERROR), base::ExitCode::numerical_failure,
                  "the matrix is singular (PETSc's factorisation failed with the reason ", static_cast<int>(failed),
                  "): are supports missing, or a material or mass zero?");
}

Eigen::VectorXd PetscSolver::solve(const Eigen::VectorXd& right_hand_side)
{
    matrix_->put(right_hand_side, right_hand_side_);
    require_petsc(KSPSolve(solver_, right_hand_side_, solution_), "solve");
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    KSPGetConvergedReason(solver_, &reason);
    base::require(reason > 0, base::ExitCode::numerical_failure, "the linear solver did not converge in ", iterations(),
                  " iterations (PETSc's reason ", static_cast<int>(reason),
                  "). Try [linear_solver] method = \"mumps\", or check supports and materials");
    return matrix_->get(solution_);
}

int PetscSolver::iterations() const
{
    PetscInt count = 0;
    KSPGetIterationNumber(solver_, &count);
    return static_cast<int>(count);
}

} // namespace fem

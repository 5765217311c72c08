// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/solve/linear_solver.hpp"
#include "fem_solver/solve/petsc_matrix.hpp"

#include <petscksp.h>

#include <optional>
#include <string>

namespace fem {

/// What PETSc solves with.
struct PetscSettings {
    enum class Method {
        mumps,       ///< direct, on any number of ranks
        gmres_gamg,  ///< GMRES with algebraic multigrid by aggregation, which knows the body's rigid motions
        gmres_hypre, ///< GMRES with hypre's BoomerAMG
        cg_jacobi    ///< conjugate gradients with the diagonal, for mass matrices
    };
    Method method = Method::mumps;
    double tolerance = 1e-12; ///< of the iterative methods: |b - A x| over |b|
    std::string options;      ///< PETSc's own, "-solver_ksp_monitor -solver_pc_gamg_threshold 0.02"
};

/// Solves on the ranks of a team with PETSc.
class PetscSolver final : public LinearSolver {
public:
    /// Collective. \param dofs outlives the solver. \throws base::Error bad_input for options that PETSc cannot read.
    PetscSolver(const PetscSettings& settings, const Mesh& mesh, const DofMap& dofs);
    ~PetscSolver() override;
    PetscSolver(const PetscSolver&) = delete;

    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) override;
    /// Iterations of the last solution; 1 for a direct method.
    int iterations() const;

private:
    void eliminate(const Matrix& matrix) override;
    void make_solver();
    void choose_conjugate_gradients();
    void choose_multigrid();
    void give_rigid_motions();

    PetscSettings settings_;
    const Mesh* mesh_;
    const DofMap* dofs_;
    std::optional<PetscMatrix> matrix_;
    Vec right_hand_side_ = nullptr, solution_ = nullptr;
    KSP solver_ = nullptr;
};

} // namespace fem

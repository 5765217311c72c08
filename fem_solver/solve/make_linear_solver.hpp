// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/solve/petsc_solver.hpp"

#include <memory>

namespace fem {

/// Which solver of linear systems is asked for.
struct SolverSettings {
    enum class Method {
        automatic, ///< alone: banded where the body is slender, else MUMPS; on several ranks MUMPS
        banded,    ///< one rank only
        sparse,    ///< one rank only
        petsc
    };
    Method method = Method::automatic;
    PetscSettings petsc = {};
};

/// \param pattern of the matrices to come. \throws base::Error bad_input for a method of one rank on several.
std::unique_ptr<LinearSolver> make_linear_solver(const SolverSettings& settings, const Mesh& mesh, const DofMap& dofs,
                                                 const Matrix& pattern);

/// For mass matrices, which need no factorisation: banded where that is asked for or cheap, else conjugate gradients.
std::unique_ptr<LinearSolver> make_mass_solver(const SolverSettings& settings, const Mesh& mesh, const DofMap& dofs,
                                               const Matrix& pattern);

} // namespace fem

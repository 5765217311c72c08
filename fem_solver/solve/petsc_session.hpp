// SPDX-License-Identifier: MIT
#pragma once

#include <petscsys.h>

namespace fem {

/// Starts PETSc unless it runs already, on the ranks of the solid: it never sees the whole world. It ends by itself when
/// MPI ends. Signals stay ours, and errors come back as codes, see require_petsc. Collective over `comm`.
void start_petsc(MPI_Comm comm);

/// \throws base::Error numerical_failure with PETSc's message when the code is not zero.
void require_petsc(PetscErrorCode code, const char* what);

} // namespace fem

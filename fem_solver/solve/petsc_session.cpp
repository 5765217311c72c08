// SPDX-License-Identifier: MIT
#include "fem_solver/solve/petsc_session.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <type_traits>

namespace fem {
namespace {

static_assert(std::is_same_v<PetscScalar, double>, "PETSc must be built for real numbers in double precision");

int end_petsc(MPI_Comm, int, void*, void*)
{
    PetscPopErrorHandler();
    PetscFinalize();
    return MPI_SUCCESS;
}

/// MPI_Finalize first of all deletes the attributes of MPI_COMM_SELF, while everything still works.
void end_with_mpi()
{
    int key = MPI_KEYVAL_INVALID;
    MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, &end_petsc, &key, nullptr);
    MPI_Comm_set_attr(MPI_COMM_SELF, key, nullptr);
    MPI_Comm_free_keyval(&key);
}

} // namespace

void start_petsc(MPI_Comm comm)
{
    PetscBool running = PETSC_FALSE;
    PetscInitialized(&running);
    if (running) return;
    PETSC_COMM_WORLD = comm;
    PetscOptionsSetValue(nullptr, "-no_signal_handler", "1");
    require_petsc(PetscInitialize(nullptr, nullptr, nullptr, nullptr), "start");
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
    end_with_mpi();
}

void require_petsc(PetscErrorCode code, const char* what)
{
    if (code == 0) return;
    const char* text = nullptr;
    PetscErrorMessage(code, &text, nullptr);
    throw base::Error(base::ExitCode::numerical_failure,
                      base::text("PETSc could not ", what, ": ", text ? text : "unknown error", " (code ", code, ")"));
}

} // namespace fem

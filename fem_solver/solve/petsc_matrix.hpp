// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/dof_map.hpp"
#include "fem_solver/dofs/sparse_matrix.hpp"

#include <petscmat.h>

namespace fem {

/// A matrix of all ranks in PETSc's hands, made of the own rows of each.
class PetscMatrix {
public:
    /// Collective; starts PETSc. \param dofs outlives the matrix. \param pattern of the matrices to come.
    PetscMatrix(const Mesh& mesh, const DofMap& dofs, const Matrix& pattern);
    ~PetscMatrix();
    PetscMatrix(const PetscMatrix&) = delete;

    /// Takes the values of a matrix with the pattern. Collective.
    void set(const Matrix& matrix);
    Mat handle() const { return matrix_; }

    /// Own entries of a vector to PETSc, and back to all local entries. Collective.
    void put(const Eigen::VectorXd& vector, Vec to) const;
    Eigen::VectorXd get(Vec from) const;

private:
    const DofMap* dofs_;
    Eigen::Index local_; // entries of a vector here
    Mat matrix_ = nullptr;
    std::vector<int> places_;    // of the own rows' entries among the values of the local matrix
    std::vector<double> values_; // of the own rows
};

/// The ranks that PETSc works on.
inline MPI_Comm petsc_comm(const DofMap& dofs)
{
    return dofs.team().comm() ? dofs.team().comm()->handle() : MPI_COMM_SELF;
}

} // namespace fem

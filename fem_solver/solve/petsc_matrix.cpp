// SPDX-License-Identifier: MIT
#include "fem_solver/solve/petsc_matrix.hpp"

#include "fem_solver/solve/petsc_session.hpp"

#include <algorithm>

namespace fem {

PetscMatrix::PetscMatrix(const Mesh& mesh, const DofMap& dofs, const Matrix& pattern)
    : dofs_(&dofs), local_(pattern.rows())
{
    start_petsc(petsc_comm(dofs));
    const auto& equations = dofs.equations();
    std::vector<PetscInt> rows, columns;
    for (int j = 0; j < pattern.outerSize(); ++j)
        for (int at = pattern.outerIndexPtr()[j]; at < pattern.outerIndexPtr()[j + 1]; ++at) {
            const int i = pattern.innerIndexPtr()[at];
            if (i >= dofs.own()) continue;
            places_.push_back(at);
            rows.push_back(static_cast<PetscInt>(equations[static_cast<std::size_t>(i)]));
            columns.push_back(static_cast<PetscInt>(equations[static_cast<std::size_t>(j)]));
        }
    values_.resize(places_.size());
    const auto size = static_cast<PetscInt>(dofs.own());
    require_petsc(MatCreate(petsc_comm(dofs), &matrix_), "make a matrix");
    require_petsc(MatSetSizes(matrix_, size, size, PETSC_DETERMINE, PETSC_DETERMINE), "size a matrix");
    require_petsc(MatSetBlockSize(matrix_, mesh.dimension), "size a matrix's blocks");
    require_petsc(MatSetType(matrix_, MATAIJ), "choose a matrix");
    require_petsc(MatSetPreallocationCOO(matrix_, static_cast<PetscCount>(rows.size()), rows.data(), columns.data()),
                  "lay out a matrix");
}

PetscMatrix::~PetscMatrix() { MatDestroy(&matrix_); }

void PetscMatrix::set(const Matrix& matrix)
{
    for (std::size_t k = 0; k < places_.size(); ++k) values_[k] = matrix.valuePtr()[places_[k]];
    require_petsc(MatSetValuesCOO(matrix_, values_.data(), INSERT_VALUES), "fill a matrix");
}

void PetscMatrix::put(const Eigen::VectorXd& vector, Vec to) const
{
    double* values = nullptr;
    require_petsc(VecGetArray(to, &values), "open a vector");
    std::copy_n(vector.data(), dofs_->own(), values);
    VecRestoreArray(to, &values);
}

Eigen::VectorXd PetscMatrix::get(Vec from) const
{
    Eigen::VectorXd vector = Eigen::VectorXd::Zero(local_);
    const double* values = nullptr;
    require_petsc(VecGetArrayRead(from, &values), "open a vector");
    std::copy_n(values, dofs_->own(), vector.data());
    VecRestoreArrayRead(from, &values);
    dofs_->refresh(vector);
    return vector;
}

} // namespace fem

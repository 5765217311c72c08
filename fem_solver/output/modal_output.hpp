// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/mode.hpp"
#include "fem_solver/output/field_file.hpp"

#include <functional>

namespace fem {

/// modes.csv: mode, frequency, residual and participating masses, a row each. Rank 0's.
void write_modes(const std::string& folder, int dimension, const std::vector<Mode>& modes);

/// The state as time 0 of the fields, then the modes' shapes as displacements from it, mode k as time k, with the largest
/// displacement a twentieth of the body's extent. Collective. \param stress of a displacement, 9 numbers per own element.
void write_shapes(FieldFile& fields, const Mesh& mesh, const DofMap& dofs, const Motion& state,
                  const std::vector<Mode>& modes,
                  const std::function<std::vector<double>(const Eigen::VectorXd&)>& stress);

} // namespace fem

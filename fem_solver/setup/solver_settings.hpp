// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/config/analysis_config.hpp"
#include "fem_solver/solve/make_linear_solver.hpp"

namespace fem {

/// What [linear_solver] asks for.
SolverSettings solver_settings(const LinearSolverConfig& config);

} // namespace fem

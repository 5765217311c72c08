// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/load.hpp"
#include "fem_solver/config/load_config.hpp"

#include <functional>
#include <memory>

namespace fem {

/// The load that a table [[loads]] describes, without its factor of time.
/// \throws base::Error bad_input for an unknown group.
std::unique_ptr<Load> make_load(const LoadConfig& config, const Mesh& mesh, const MatrixPattern& pattern);

/// A formula of the time t [s].
std::function<double(double)> function_of_time(const base::Formula& formula);

} // namespace fem

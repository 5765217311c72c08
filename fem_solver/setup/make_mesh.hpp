// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/config/solid_config.hpp"
#include "fem_solver/mesh/mesh.hpp"

namespace fem {

/// The mesh of a configuration, the built-in block or what a MED file holds: this rank's part of it. Every rank makes or
/// reads the whole mesh, and drops what is not its part. Collective. \throws base::Error bad_input.
Mesh make_mesh(const SolidConfig& config, const Team& team);

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/config/body_config.hpp"
#include "fem_solver/mesh/mesh.hpp"

namespace fem {

/// The mesh of a configuration: the built-in block or what a MED file holds. \throws base::Error bad_input.
Mesh make_mesh(const MeshConfig& config, int dimension);

} // namespace fem

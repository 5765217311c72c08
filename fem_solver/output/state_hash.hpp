// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/motion.hpp"
#include "fem_solver/mesh/mesh.hpp"

#include <string>

namespace fem {

/// 16 hexadecimal digits of the motion's bits in the order of the whole mesh's nodes: equal hashes mean bit-identical
/// results. Collective.
std::string state_hash(const Mesh& mesh, const Motion& motion);

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/dofs/motion.hpp"

#include <string>

namespace fem {

/// 16 hexadecimal digits of the motion's bits in node order: equal hashes mean bit-identical results.
std::string state_hash(const Motion& motion);

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/config/wall_config.hpp"
#include "sph_solver/walls/rigid_motion.hpp"

namespace sph {

/// What the motions of a run have in common.
struct MotionSpan {
    double start = 0, end = 0;  ///< of the run [s]; a table must cover it
    double derivative_step = 0; ///< h of base::with_derivatives for formulas [s]
};

/// The motion of a wall from its formulas or its table. Throws Error(bad_input), naming the wall or the file.
template<int D> RigidMotion<D> make_motion(const WallConfig& wall, const MotionSpan& span);

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/equation_of_state.hpp"
#include "sph_solver/numerics/face_motion.hpp"
#include "sph_solver/numerics/kernel.hpp"
#include "sph_solver/numerics/limiter.hpp"
#include "sph_solver/numerics/pair_area.hpp"
#include "sph_solver/numerics/riemann.hpp"
#include "sph_solver/numerics/vector.hpp"

namespace sph {

/// What every pair formula of a run has in common, constant from setup to the end.
template<int D> struct FluidModel {
    CubicSpline<D> kernel;
    Tait eos;
    Limiter limiter;                 ///< van Albada unless the user says otherwise
    Vec<D> gravity = Vec<D>::Zero(); ///< g [m/s^2]
    Riemann riemann = ExactRiemann{};
    FaceMotion face_motion = MeanMotion{};
    PairArea pair_area = RawArea{};
};

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/config/fluid_config.hpp"
#include "sph_solver/numerics/fluid_model.hpp"

namespace sph {

/// What the method's formulas have in common, from the configuration: this is where its options become objects.
template<int D> FluidModel<D> make_model(const FluidConfig& config);

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/session/session.hpp"
#include "sph_solver/config/fluid_config.hpp"

namespace sph {

/// What the fluid sends and needs in a coupled run, for `--check`.
coupler::DataFlow data_flow(const FluidConfig& config, const coupler::Session& session);

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/session/session.hpp"
#include "fem_solver/setup/solid_model.hpp"

namespace fem {

/// What the solid brings, sends and needs in a coupled run, for `--check`.
coupler::DataFlow data_flow(const SolidConfig& config, const SolidModel& model, const coupler::Session& session);

} // namespace fem

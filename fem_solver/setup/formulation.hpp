// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_body.hpp"
#include "fem_solver/config/solid_config.hpp"

#include <string>

namespace fem {

/// The element formulation of a configuration.
BodySettings body_settings(const MeshConfig& config);

/// Says where elements are too stiff, in bending or because the material hardly changes its volume, and what to choose
/// instead; empty where they are not. Such choices are there to show locking (figures: docs/theory/solid.md).
std::string locking_warning(ElementType type, const SolidConfig& config);

} // namespace fem

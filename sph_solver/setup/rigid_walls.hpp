// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/config/fluid_config.hpp"
#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/walls/walls.hpp"

namespace sph {

/// The walls of the configuration, where they are at the start; each wall of the file is one body, first those that stand
/// still. \param end of the run [s], as far as motions must be known.
template<int D> Walls<D> make_walls(const FluidConfig& config, const FluidModel<D>& model, double end);

/// Throws Error(bad_input) when water starts inside a wall: deeper than `tolerance` particle spacings.
/// Collective; \pre walls.find_contacts(particles) on every rank.
template<int D> void require_dry_walls(const Walls<D>& walls, const base::Communicator& comm, double tolerance);

} // namespace sph

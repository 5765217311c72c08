// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/config/fluid_config.hpp"
#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/setup/initial_fields.hpp"
#include "sph_solver/state/particles.hpp"

namespace sph {

/// This rank's share of the water at the start: conserved fields of owned particles, m = rho w and P = m v.
///
/// Particles are numbered through the bodies of water in the file's order; a number does not depend on the ranks. The
/// share is a range of numbers: which rank a particle belongs to is for Domain::redistribute to say.
/// Throws Error(bad_input) when bodies of water overlap, a shape is too small for the resolution, or a file or formula
/// cannot be used. Collective.
template<int D>
Particles<D> initial_particles(const FluidConfig& config, const FluidModel<D>& model, const base::Communicator& comm);

} // namespace sph

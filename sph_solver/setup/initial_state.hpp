// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/communicator.hpp"
#include "sph_solver/config/fluid_config.hpp"
#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/setup/water_body.hpp"
#include "sph_solver/state/particles.hpp"

namespace sph {

/// Density of the water at rest under gravity, at the depth d below the free surface [kg/m^3]:
///
///     rho = rho0 (1 + (gamma - 1) |g| d / c0^2)^(1/(gamma - 1)),     rho0 for d <= 0
///
/// from dp/dd = rho |g| with Tait's c^2 = dp/drho.
double hydrostatic_density(const Tait& eos, double gravity, double depth);

/// What the method's formulas have in common, from the configuration.
template<int D> FluidModel<D> make_model(const FluidConfig& config);

/// This rank's share of the water at the start: conserved fields of owned particles, m = rho w and P = m v.
///
/// Particles are numbered through the bodies of water in the file's order; a number does not depend on the ranks. The
/// share is a range of numbers: which rank a particle belongs to is for Domain::redistribute to say.
/// Throws Error(bad_input) when two boxes of water overlap or a shape is too small for the resolution.
template<int D>
Particles<D> initial_particles(const FluidConfig& config, const FluidModel<D>& model, const base::Communicator& comm);

} // namespace sph

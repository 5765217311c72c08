// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/config/fluid_config.hpp"
#include "sph_solver/numerics/fluid_model.hpp"

#include <functional>

namespace sph {

/// Density of the water at rest under gravity, at the depth d below the free surface [kg/m^3]:
///
///     rho = rho0 (1 + (gamma - 1) |g| d / c0^2)^(1/(gamma - 1)),     rho0 for d <= 0
///
/// from dp/dd = rho |g| with Tait's c^2 = dp/drho.
double hydrostatic_density(const Tait& eos, double gravity, double depth);

template<int D> using DensityField = std::function<double(const Vec<D>&)>;  ///< [kg/m^3] at x [m]
template<int D> using VelocityField = std::function<Vec<D>(const Vec<D>&)>; ///< [m/s] at x [m]

/// Density of a body at the start, from the pressure that [initial] states.
/// \param level free surface where neither the body nor [initial] names one [m].
/// Throws Error(bad_input) for a formula that cannot be read; the field, for a pressure below -B, which no density has.
template<int D>
DensityField<D> initial_density(const FluidConfig& config, const WaterConfig& water, const FluidModel<D>& model,
                                double level);

/// Velocity of a body at the start; empty when the configuration states none.
template<int D> VelocityField<D> initial_velocity(const WaterConfig& water);

} // namespace sph

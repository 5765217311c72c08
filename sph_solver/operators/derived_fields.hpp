// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/equation_of_state.hpp"
#include "sph_solver/state/particles.hpp"

namespace sph {

/// Velocity, density, pressure and sound speed of all local particles from mass, volume and momentum:
///
///     v = P / m,   rho = m / w,   p = p(rho),   c = c(rho)
///
/// Throws Error(numerical_failure) that names the particle when a mass or a volume is not positive, or not a number.
template<int D> void update_derived(Particles<D>& particles, const Tait& eos);
/// The same for some of the particles.
template<int D> void update_derived(Particles<D>& particles, const Tait& eos, const std::vector<int>& which);

} // namespace sph

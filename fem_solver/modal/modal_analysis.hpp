// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/dofs/mode.hpp"
#include "fem_solver/dofs/supports.hpp"

namespace fem {

/// The lowest natural frequencies, K phi = w^2 M phi, K the tangent at the motion's displacement.
///
/// Krylov-Schur with shift and invert (SLEPc, MUMPS) about a small negative w^2: K - sigma M is then regular for bodies
/// that nothing holds, too. The shift is 1e-8 of trace K over trace M, which is of the order of the highest w^2 of the
/// mesh: small against what is sought, large against round-off. While the factors of K - sigma M have negative pivots,
/// some w^2 lie below: the state is unstable, and the shift is lowered tenfold, so that the lowest come first there, too.
///
/// Of a tangent that is not symmetric its symmetric part is taken, see asymmetry.
///
/// \param load_factor of the loads that hold the state, 0: unloaded. \param count how many modes. Collective. \throws base::Error bad_input when the body has fewer; numerical_failure when
/// they do not converge.
std::vector<Mode> find_modes(const Mesh& mesh, const SolidForces& forces, const Supports& supports, const Motion& state,
                             double load_factor, int count);

/// Largest |K_ij - K_ji| over the largest |K_ij| of the tangent of a loaded state: what follower loads bring to it.
/// Collective.
double asymmetry(const SolidForces& forces, const Motion& state);

} // namespace fem

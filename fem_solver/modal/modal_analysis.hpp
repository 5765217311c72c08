// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/dofs/supports.hpp"

namespace fem {

/// A natural vibration of the body about its present state.
struct Mode {
    double angular_frequency = 0; ///< w [rad/s]; zero for a rigid motion
    Eigen::VectorXd shape;        ///< phi, with phi . M phi = 1 [kg^-1/2] (2D: (kg/m)^-1/2); largest entry positive
    double residual = 0;          ///< max |K phi - w^2 M phi| over max (|K| |phi|)
    /// Participating mass (phi . M e)^2 along each axis, e the unit translation [kg] (2D: kg/m): over all modes they sum up
    /// to the mass that is not held.
    std::vector<double> masses;

    double frequency() const; ///< [Hz]
};

/// The lowest natural frequencies, K phi = w^2 M phi, K the tangent at the motion's displacement.
///
/// Krylov-Schur with shift and invert (SLEPc, MUMPS) about a small negative w^2: K - sigma M is then regular for bodies
/// that nothing holds, too. The shift is 1e-8 of trace K over trace M, which is of the order of the highest w^2 of the
/// mesh: small against what is sought, large against round-off.
///
/// \param count how many modes. Collective. \throws base::Error bad_input when the body has fewer; numerical_failure when
/// they do not converge.
std::vector<Mode> find_modes(const Mesh& mesh, const SolidForces& forces, const Supports& supports,
                             const Motion& state, int count);

/// Largest |K_ij - K_ji| over the largest |K_ij| of a tangent: follower loads bring it. Collective.
double asymmetry(const DofMap& dofs, const Matrix& tangent);

} // namespace fem

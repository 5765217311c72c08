// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/dofs/solid_energies.hpp"
#include "fem_solver/dofs/supports.hpp"
#include "fem_solver/time/hht.hpp"

namespace fem {

/// The exact energy identity of HHT, for any nonlinear forces. With f^h_n = (1+alpha) f_n - alpha f_(n-1) and
/// <f> = du . [(1-gamma) f^h_0 + gamma f^h_1]:
///
///     dT + <f_int> + <C v> - <f_ext> + dt^2 (beta - gamma/2) [ d(1/2 a.M a) + (gamma - 1/2) da.M da ] = 0
///
/// Every force is booked by its own <f>; what <f_int> exceeds the change of strain energy, and what the material has taken, by
/// belongs, with the last term, to the numerical dissipation. The rest is the Newton residual's work: `balance_error`.
///
/// Supports on a given path have the path's own velocity and acceleration, which the scheme's two relations miss by
/// dv - dt [(1-gamma) a_0 + gamma a_1] = r_v and du - dt v_0 - dt^2 [...] = r_u, of third order in dt. That part of the
/// supports' work is booked with them, with a_m = (1-gamma) a_0 + gamma a_1:
///
///     (dt r_v / 2 - r_u) . M a_m + r_v . M (v_0 + v_1)/2
///
/// It is booked entry by entry, as is du . [(1-gamma) R_0 + gamma R_1] of the reactions R, and summed over each group.
class EnergyLedger {
public:
    EnergyLedger(const SolidForces& forces, const Supports& supports, const Hht& hht)
        : forces_(&forces), supports_(&supports), hht_(hht)
    {}

    /// Opens the books with the forces of the initial state, from which the initial acceleration was solved.
    void start(const Motion& motion, const Forces& forces);
    /// Books a converged step, which the material has accepted. \param forces_n, forces_np1 forces at its start and end.
    void account(const Motion& motion_n, const Motion& motion_np1, const Forces& forces_n, const Forces& forces_np1,
                 double dt);
    const SolidEnergies& energies() const { return energies_; }
    /// Reaction of the supports at the end of the last step, M a + g^h on the held entries, zero elsewhere [N].
    const Eigen::VectorXd& reaction() const { return reaction_; }

private:
    Eigen::VectorXd support_force(const Motion& motion, const Forces& weighted) const;
    Eigen::VectorXd imposed_work(const Motion& motion_n, const Motion& motion_np1, double dt) const;

    const SolidForces* forces_;
    const Supports* supports_;
    Hht hht_;
    SolidEnergies energies_;
    double initial_total_ = 0, initial_material_ = 0;
    Forces weighted_;          // f^h of the last step
    Eigen::VectorXd reaction_; // of the last step
};

} // namespace fem

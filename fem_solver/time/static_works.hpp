// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/dofs/solid_energies.hpp"
#include "fem_solver/dofs/supports.hpp"

namespace fem {

/// Works of a static solution, from equilibrium to equilibrium by the trapezoidal rule:
///
///     W += (u_1 - u_0) . (f_0 + f_1)/2      for each load, the supports' reactions, and gravity as it is raised
///
/// exact where forces change linearly with the displacement. `balance_error`, the change of strain energy less all
/// works, is what the rule misses: of second order in the stride.
class StaticWorks {
public:
    StaticWorks(const SolidForces& forces, const Supports& supports) : forces_(&forces), supports_(&supports) {}

    /// Opens the books with the unloaded state. \param now its forces.
    void start(const Motion& motion, const Forces& now);
    /// Books a stride that ended in equilibrium.
    void account(const Motion& motion, const Forces& now);
    const SolidEnergies& energies() const { return energies_; }

private:
    Eigen::VectorXd reaction(const Forces& forces) const { return supports_->held_part(forces.unbalanced()); }

    const SolidForces* forces_;
    const Supports* supports_;
    SolidEnergies energies_;
    double first_strain_ = 0, gravity_ = 0; // strain energy at the start, work of gravity
    Eigen::VectorXd displacement_;          // of the last equilibrium, and its forces
    Forces last_;
};

} // namespace fem

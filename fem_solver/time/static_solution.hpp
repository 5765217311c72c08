// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/dofs/supports.hpp"
#include "fem_solver/solve/linear_solver.hpp"
#include "fem_solver/solve/newton.hpp"

#include <functional>
#include <string>

namespace fem {

/// Equilibrium f_int(u) = s f_ext(u) for load factors s that rise to 1 in equal parts, by full Newton.
/// A part that does not converge is cut into shorter strides.
class StaticSolution {
public:
    /// All references outlive the object.
    StaticSolution(const Mesh& mesh, const SolidForces& forces, const Supports& supports, const NewtonSettings& newton);

    /// Called after each load step with the load factor.
    using Observer = std::function<void(double factor)>;

    /// Raises the load in `load_steps` parts from the motion's displacement; velocity and acceleration stay zero.
    /// \throws base::Error numerical_failure naming the worst node, its position and the load factor.
    void solve(Motion& motion, int load_steps, const Observer& observer);

    /// Forces of the supports in equilibrium, zero elsewhere [N] (2D: N/m).
    Eigen::VectorXd reaction() const { return supports_.held_part(forces_now_.unbalanced()); }
    /// Residuals of the last load step's iterations, largest nodal entry [N].
    const std::vector<double>& residuals() const { return newton_.residuals(); }
    long iterations() const { return solver_.factorisations(); }

private:
    void raise(Motion& motion, double from, double to);
    bool equilibrate(Motion& motion, double factor);
    bool apply(Motion& motion, const Eigen::VectorXd& correction, double factor);
    [[noreturn]] void fail(const Motion& motion, double factor) const;

    const Mesh& mesh_;
    const SolidForces& model_;
    const Supports& supports_;
    NewtonMonitor newton_;
    LinearSolver solver_;
    Forces forces_now_;
    std::string reason_; // of the last failure
};

} // namespace fem

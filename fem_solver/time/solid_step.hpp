// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/solve/linear_solver.hpp"
#include "fem_solver/solve/newton.hpp"
#include "fem_solver/time/energy_ledger.hpp"

namespace fem {

/// Where Newton's iteration of a step starts: with the acceleration or with the displacement of the step's start.
enum class Predictor { constant_acceleration, still };

/// One implicit HHT step of the solid after the other.
///
/// The factorisation is kept over the steps and renewed when it contracts too little or the step length has changed by
/// more than 2 %. An iteration that fails from the chosen start is tried once more from the displacement of the step's
/// start with a new factorisation.
class SolidStep {
public:
    /// All references outlive the step.
    SolidStep(const Mesh& mesh, const SolidForces& forces, const Supports& supports, const Hht& hht,
              const NewtonSettings& newton, Predictor predictor = Predictor::constant_acceleration);

    /// Solves the initial acceleration, M a_0 = - g_0, for the loads as they are now, and opens the energy books.
    void start(Motion& motion);
    /// Advances the motion by dt [s]; the loads must hold what acts at the end of the step.
    /// \throws base::Error numerical_failure naming the worst node, its position, the step and what to try.
    void advance(Motion& motion, double dt);

    const SolidEnergies& energies() const { return ledger_.energies(); }
    const Eigen::VectorXd& reaction() const { return ledger_.reaction(); }
    /// Nodal forces by origin at the end of the last step.
    const Forces& forces() const { return forces_n_; }
    long steps() const { return steps_; }
    long iterations() const { return iterations_; }
    long factorisations() const { return solver_.factorisations(); }

private:
    bool iterate(Motion& motion, Predictor predictor, double dt);
    bool predict(Motion& motion, Predictor predictor, double dt);
    Eigen::VectorXd residual(const Eigen::VectorXd& inertia) const;
    double force_scale(const Eigen::VectorXd& inertia) const;
    void factorise(const Motion& motion, double dt);
    [[nodiscard]] bool apply(Motion& motion, const Eigen::VectorXd& correction, double dt);
    [[noreturn]] void fail(const Motion& motion, double dt) const;

    const Mesh& mesh_;
    const SolidForces& model_;
    const Supports& supports_;
    Hht hht_;
    NewtonMonitor newton_;
    Predictor predictor_;
    LinearSolver solver_;
    EnergyLedger ledger_;
    Forces forces_n_, forces_np1_;
    double factorised_dt_ = 0;
    double time_ = 0;
    long steps_ = 0, iterations_ = 0;
};

} // namespace fem

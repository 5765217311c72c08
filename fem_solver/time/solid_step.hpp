// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/solve/make_linear_solver.hpp"
#include "fem_solver/time/energy_ledger.hpp"
#include "fem_solver/time/failure.hpp"

#include <functional>
#include <string>

namespace fem {

/// Where Newton's iteration of a step starts.
enum class Predictor {
    continued,             ///< the displacement changes as fast as on average over the step before
    constant_acceleration, ///< with the acceleration of the step's start
    still                  ///< with the displacement of the step's start
};

/// Choices of the step.
struct StepSettings {
    NewtonSettings newton;
    Predictor predictor = Predictor::constant_acceleration;
    int sub_steps = 1; ///< equal HHT steps in each step
    SolverSettings solver = {};
};

/// One implicit step of the solid after the other, in one HHT step or several.
///
/// An HHT step that does not converge is cut in halves of halves, down to 1/64, which are joined again where they are easy.
/// Loads of the configuration are taken at each sub-step's own time; a fluid's load changes linearly over the step.
/// The factorisation is kept over the steps and renewed when it contracts too little or the step length has changed by
/// more than 2 %. An iteration that fails from the chosen start is tried once more from the displacement of the step's
/// start with a new factorisation.
class SolidStep {
public:
    /// All references outlive the step.
    SolidStep(const Mesh& mesh, SolidForces& forces, const Supports& supports, const Hht& hht,
              const StepSettings& settings);

    /// Called with a line for the log whenever an HHT step is cut.
    using Reporter = std::function<void(const std::string& line)>;
    void report_to(Reporter reporter) { report_ = std::move(reporter); }

    /// Solves the initial acceleration, M a_0 = - g_0, for the loads as they are now, and opens the energy books.
    void start(Motion& motion);
    /// Advances the motion by dt [s]; the loads must hold what acts at the end of the step.
    /// \throws base::Error numerical_failure naming node or element, its position, the step and what to try.
    void advance(Motion& motion, double dt);

    const SolidEnergies& energies() const { return ledger_.energies(); }
    const Eigen::VectorXd& reaction() const { return ledger_.reaction(); }
    /// Nodal forces by origin at the end of the last step.
    const Forces& forces() const { return forces_n_; }
    long steps() const { return steps_; }
    long sub_steps() const { return sub_steps_; }
    long iterations() const { return iterations_; }
    long factorisations() const { return solver_->factorisations(); }

private:
    void advance_part(Motion& motion, double dt, const std::function<void(double)>& set_load);
    bool attempt(Motion& motion, double dt);
    bool iterate(Motion& motion, Predictor predictor, double dt);
    bool solve(Motion& motion, double dt);
    bool evaluate(const Motion& motion, double dt);
    void predict(Motion& motion, Predictor predictor, double dt);
    Eigen::VectorXd residual(const Eigen::VectorXd& inertia) const;
    double force_scale(const Eigen::VectorXd& inertia) const;
    void factorise(const Motion& motion, double dt);
    [[nodiscard]] bool apply(Motion& motion, const Eigen::VectorXd& correction, double dt);
    bool fails(const Failure& failure)
    {
        failure_ = failure;
        return false;
    }
    std::string failure_text(const Motion& motion, double dt) const;

    const Mesh& mesh_;
    SolidForces& model_;
    const Supports& supports_;
    Hht hht_;
    StepSettings settings_;
    NewtonMonitor newton_;
    std::unique_ptr<LinearSolver> solver_;
    EnergyLedger ledger_;
    Forces forces_n_, forces_np1_;
    Failure failure_; // the last one
    Reporter report_ = [](const std::string&) {};
    double factorised_dt_ = 0;
    Eigen::VectorXd pace_; ///< (u_1 - u_0)/dt of the last HHT step [m/s]; empty before the first
    double time_ = 0;
    long steps_ = 0, sub_steps_ = 0, iterations_ = 0;
};

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/dofs/supports.hpp"
#include "fem_solver/solve/make_linear_solver.hpp"
#include "fem_solver/time/failure.hpp"
#include "fem_solver/time/static_works.hpp"

#include <functional>
#include <string>

namespace fem {

/// The t that a static solution gives to the formulas of loads and supports.
enum class LoadTime {
    factor, ///< the load factor
    start   ///< zero: the state in which a motion begins
};

/// Choices of a static solution.
struct StaticSettings {
    NewtonSettings newton;
    SolverSettings solver = {};
    LoadTime time = LoadTime::factor;
};

/// Equilibrium f_int(u) = s f_ext(u) for load factors s that rise to 1 in equal parts, by full Newton.
/// A part that does not converge is cut into shorter strides, which grow again after one that was easy.
class StaticSolution {
public:
    /// All references outlive the object.
    StaticSolution(const Mesh& mesh, const SolidForces& forces, const Supports& supports,
                   const StaticSettings& settings);

    /// Called after each load step with the load factor.
    using Observer = std::function<void(double factor)>;
    /// Called with a line for the log whenever a stride is cut.
    using Reporter = std::function<void(const std::string& line)>;
    void report_to(Reporter reporter) { report_ = std::move(reporter); }

    /// Raises the load in `load_steps` parts from the motion's displacement; velocity and acceleration stay as they
    /// are. \throws base::Error numerical_failure naming the stride, node or element, and position.
    void solve(Motion& motion, int load_steps, const Observer& observer);

    /// Energies now, and the works since the unloaded state.
    const SolidEnergies& energies() const { return works_.energies(); }
    /// Forces of the supports in equilibrium, zero elsewhere [N] (2D: N/m).
    Eigen::VectorXd reaction() const { return supports_.held_part(forces_now_.unbalanced()); }
    /// Residuals of the last load step's iterations, largest nodal entry [N].
    const std::vector<double>& residuals() const { return newton_.residuals(); }
    long iterations() const { return solver_->factorisations(); }

private:
    void raise(Motion& motion, int step, int load_steps);
    double time(double factor) const { return time_ == LoadTime::factor ? factor : 0; }
    bool equilibrate(Motion& motion, double factor);
    bool solve(Motion& motion, double factor);
    bool factorise(const Matrix& matrix);
    bool apply(Motion& motion, const Eigen::VectorXd& correction, double factor);
    bool easy() const { return std::ssize(newton_.residuals()) <= easy_iterations; }
    bool fails(const Failure& failure)
    {
        failure_ = failure;
        return false;
    }

    const Mesh& mesh_;
    const SolidForces& model_;
    const Supports& supports_;
    NewtonMonitor newton_;
    std::unique_ptr<LinearSolver> solver_;
    Forces forces_now_;
    LoadTime time_;
    StaticWorks works_;
    Reporter report_ = [](const std::string&) {};
    Failure failure_; // the last one
    double size_;     // largest coordinate of the body [m]
    /// A stride with no more residuals than this may be followed by one twice as long.
    static constexpr std::ptrdiff_t easy_iterations = 8;
};

} // namespace fem

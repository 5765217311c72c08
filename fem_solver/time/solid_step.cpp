// SPDX-License-Identifier: MIT
#include "fem_solver/time/solid_step.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <cmath>

namespace fem {
namespace {

/// Backtracking gives up after halving a correction so many times.
constexpr int max_halvings = 12;
/// A kept factorisation survives this relative change of the step length.
constexpr double same_dt = 0.02;

} // namespace

SolidStep::SolidStep(const Mesh& mesh, const SolidForces& forces, const Supports& supports, const Hht& hht,
                     const NewtonSettings& newton, Predictor predictor)
    : mesh_(mesh),
      model_(forces),
      supports_(supports),
      hht_(hht),
      newton_(newton),
      predictor_(predictor),
      ledger_(forces, supports, hht),
      forces_n_(Forces::zero(forces.dofs())),
      forces_np1_(forces_n_)
{}

void SolidStep::start(Motion& motion)
{
    supports_.set_motion(time_, motion);
    const Inversion inversion = model_.evaluate(motion, 1, forces_n_, time_);
    base::require(!inversion.happened(), base::ExitCode::numerical_failure, "element ", inversion.element,
                  " is inverted in the initial state");
    Matrix mass = model_.mass();
    supports_.clear(mass, mass.diagonal().mean());
    const Eigen::VectorXd held = supports_.held_part(motion.acceleration);
    Eigen::VectorXd right_hand_side = -forces_n_.unbalanced() - model_.inertia(held);
    supports_.clear_rows(right_hand_side);
    LinearSolver solver;
    solver.factorise(mass);
    motion.acceleration = solver.solve(right_hand_side) + held;
    ledger_.start(motion, forces_n_);
}

void SolidStep::advance(Motion& motion, double dt)
{
    const Motion motion_n = motion;
    if (!iterate(motion, predictor_, dt)) {
        motion = motion_n;
        factorised_dt_ = 0; // the second attempt shares nothing with the first
        if (!iterate(motion, Predictor::still, dt)) fail(motion, dt);
    }
    ledger_.account(motion_n, motion, forces_n_, forces_np1_, dt);
    std::swap(forces_n_, forces_np1_);
    time_ += dt;
    ++steps_;
}

/// Newton's iteration from a prediction; false when it does not converge.
bool SolidStep::iterate(Motion& motion, Predictor predictor, double dt)
{
    if (!predict(motion, predictor, dt)) return false;
    for (newton_.start();;) {
        const Eigen::VectorXd inertia = model_.inertia(motion.acceleration);
        Eigen::VectorXd r = residual(inertia);
        supports_.clear_rows(r);
        if (newton_.converged(r, force_scale(inertia), model_.round_off(motion))) return true;
        if (newton_.exhausted()) return false;
        if (newton_.slow() || std::abs(dt - factorised_dt_) > same_dt * factorised_dt_) factorise(motion, dt);
        if (!apply(motion, solver_.solve(-r), dt)) return false;
    }
}

bool SolidStep::predict(Motion& motion, Predictor predictor, double dt)
{
    if (predictor == Predictor::still)
        hht_.predict_still(motion, dt);
    else
        hht_.predict(motion, dt);
    supports_.set_motion(time_ + dt, motion);
    return !model_.evaluate(motion, 1, forces_np1_, time_ + dt).happened();
}

/// M a_1 + (1 + alpha) g_1 - alpha g_0
Eigen::VectorXd SolidStep::residual(const Eigen::VectorXd& inertia) const
{
    return inertia + (1 + hht_.alpha()) * forces_np1_.unbalanced() - hht_.alpha() * forces_n_.unbalanced();
}

/// The largest nodal force of the iterate, which residuals are measured by.
double SolidStep::force_scale(const Eigen::VectorXd& inertia) const
{
    const auto largest = [](const Eigen::VectorXd& v) { return v.cwiseAbs().maxCoeff(); };
    return std::max({largest(forces_np1_.internal), largest(forces_np1_.interface), largest(forces_np1_.loads),
                     largest(forces_np1_.gravity), largest(inertia)});
}

void SolidStep::factorise(const Motion& motion, double dt)
{
    Matrix matrix = model_.tangent(
        motion, {hht_.acceleration_slope(dt), 1 + hht_.alpha(), hht_.velocity_slope(dt), 1.0, time_ + dt});
    supports_.clear(matrix, matrix.diagonal().mean());
    solver_.factorise(matrix);
    factorised_dt_ = dt;
}

/// Adds the correction, halved until no element is turned inside out (det F > 0 everywhere). False when none helps.
bool SolidStep::apply(Motion& motion, const Eigen::VectorXd& correction, double dt)
{
    ++iterations_;
    double scale = 1;
    hht_.correct(motion, correction, scale, dt);
    for (int halvings = 0; model_.evaluate(motion, 1, forces_np1_, time_ + dt).happened(); ++halvings) {
        if (halvings == max_halvings || !correction.allFinite()) return false;
        scale *= 0.5;
        hht_.correct(motion, correction, -scale, dt);
    }
    return true;
}

void SolidStep::fail(const Motion& motion, double dt) const
{
    const int node = static_cast<int>(newton_.worst()) / mesh_.dimension;
    std::string displaced;
    for (int k = 0; k < mesh_.dimension; ++k)
        displaced += base::text(k > 0 ? ", " : "", motion.displacement[node * mesh_.dimension + k]);
    throw base::Error(base::ExitCode::numerical_failure,
                      base::text("the solid's step ", steps_ + 1, " from t = ", time_, " s, dt = ", dt,
                                 " s, did not converge in ", newton_.residuals().size(),
                                 " iterations: largest residual ", newton_.residuals().back(), " N at node ", node,
                                 ", reference position ", mesh_.describe_node(node), " m, displacement (", displaced,
                                 ") m. Try a smaller time step, a finer mesh there, or check the load"));
}

} // namespace fem

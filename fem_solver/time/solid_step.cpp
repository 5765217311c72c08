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
/// Into so many parts an HHT step may be cut.
constexpr int most_parts = 64;

} // namespace

SolidStep::SolidStep(const Mesh& mesh, SolidForces& forces, const Supports& supports, const Hht& hht,
                     const StepSettings& settings)
    : mesh_(mesh),
      model_(forces),
      supports_(supports),
      hht_(hht),
      settings_(settings),
      newton_(settings.newton, forces.map()),
      solver_(make_linear_solver(settings.solver, mesh, forces.map(), forces.pattern().zero())),
      ledger_(forces, supports, hht),
      forces_n_(Forces::zero(forces.dofs())),
      forces_np1_(forces_n_)
{}

void SolidStep::start(Motion& motion)
{
    supports_.set_motion(time_, motion);
    const Inversion inversion = model_.evaluate(motion, 1, forces_n_, time_);
    if (inversion.happened()) {
        fails({Failure::Kind::inversion, inversion});
        throw base::Error(base::ExitCode::numerical_failure,
                          "the initial state " + describe(failure_, mesh_, motion, newton_));
    }
    Matrix mass = model_.mass();
    supports_.clear(mass, mass.diagonal().mean());
    const Eigen::VectorXd held = supports_.held_part(motion.acceleration);
    Eigen::VectorXd right_hand_side = -forces_n_.unbalanced() - model_.inertia(held);
    supports_.clear_rows(right_hand_side);
    const auto solver = make_mass_solver(settings_.solver, mesh_, model_.map(), mass);
    solver->factorise(mass);
    motion.acceleration = solver->solve(right_hand_side) + held;
    ledger_.start(motion, forces_n_);
}

void SolidStep::advance(Motion& motion, double dt)
{
    const Forces start = forces_n_;
    const double t_n = time_;
    for (int k = 0; k < settings_.sub_steps; ++k)
        advance_part(motion, dt / settings_.sub_steps,
                     [&](double part) { model_.set_window((k + part) / settings_.sub_steps, start); });
    time_ = t_n + dt;
    ++steps_;
}

/// One HHT step, or its halves of halves where it does not converge. \param set_load sets the fluid's load for the end of
/// the given part of the step, 0 to 1.
void SolidStep::advance_part(Motion& motion, double dt, const std::function<void(double)>& set_load)
{
    int stride = most_parts;
    for (int done = 0; done < most_parts;) {
        const Motion motion_n = motion;
        const double length = dt * stride / most_parts;
        set_load(static_cast<double>(done + stride) / most_parts);
        if (attempt(motion, length)) {
            model_.accept(motion, time_ + length);
            ledger_.account(motion_n, motion, forces_n_, forces_np1_, length);
            pace_ = (motion.displacement - motion_n.displacement) / length;
            std::swap(forces_n_, forces_np1_);
            time_ += length;
            ++sub_steps_;
            done += stride;
            if (done % (2 * stride) == 0 && done < most_parts) stride *= 2; // two halves are done
            continue;
        }
        const std::string what = failure_text(motion, length);
        if (stride == 1)
            throw base::Error(base::ExitCode::numerical_failure,
                              what + ". Try a smaller time step, a finer mesh there, or check loads and supports");
        report_(what + "; half of it is tried");
        motion = motion_n;
        stride /= 2;
    }
}

/// One HHT step from the chosen prediction or else from the displacement of its start; false when neither converges.
bool SolidStep::attempt(Motion& motion, double dt)
{
    const Motion motion_n = motion;
    if (iterate(motion, settings_.predictor, dt)) return true;
    motion = motion_n;
    factorised_dt_ = 0; // the second attempt shares nothing with the first
    return iterate(motion, Predictor::still, dt);
}

/// From a prediction to equilibrium with what the body touches; false when it does not converge.
bool SolidStep::iterate(Motion& motion, Predictor predictor, double dt)
{
    model_.contact().restore();
    predict(motion, predictor, dt);
    for (;;) {
        if (!solve(motion, dt)) return false;
        const Augmentation contact = model_.contact().augment(motion, time_ + dt);
        if (contact == Augmentation::settled) return true;
        if (contact == Augmentation::unsettled)
            return fails({Failure::Kind::unsettled, {}, -1, model_.contact().complaint()});
    }
}

/// Newton's iteration with the contact's present multipliers.
bool SolidStep::solve(Motion& motion, double dt)
{
    newton_.start();
    if (!evaluate(motion, dt)) return false;
    for (;;) {
        const Eigen::VectorXd inertia = model_.inertia(motion.acceleration);
        Eigen::VectorXd r = residual(inertia);
        supports_.clear_rows(r);
        if (newton_.converged(r, force_scale(inertia), model_.round_off(motion))) return true;
        if (newton_.broken()) return fails({Failure::Kind::not_a_number});
        if (newton_.exhausted()) return fails({});
        if (newton_.slow() || std::abs(dt - factorised_dt_) > same_dt * factorised_dt_) factorise(motion, dt);
        if (!apply(motion, solver_->solve(-r), dt)) return false;
    }
}

void SolidStep::predict(Motion& motion, Predictor predictor, double dt)
{
    if (predictor == Predictor::constant_acceleration || (predictor == Predictor::continued && pace_.size() == 0)) {
        hht_.predict(motion, dt);
    } else {
        hht_.predict_still(motion, dt);
        if (predictor == Predictor::continued) hht_.correct(motion, pace_, dt, dt);
    }
    supports_.set_motion(time_ + dt, motion);
}

/// Forces at the end of the step; false where an element is turned inside out.
bool SolidStep::evaluate(const Motion& motion, double dt)
{
    const Inversion inversion = model_.evaluate(motion, 1, forces_np1_, time_ + dt);
    return !inversion.happened() || fails({Failure::Kind::inversion, inversion});
}

/// M a_1 + (1 + alpha) g_1 - alpha g_0
Eigen::VectorXd SolidStep::residual(const Eigen::VectorXd& inertia) const
{
    return inertia + (1 + hht_.alpha()) * forces_np1_.unbalanced() - hht_.alpha() * forces_n_.unbalanced();
}

/// The largest nodal force of the iterate, which residuals are measured by.
double SolidStep::force_scale(const Eigen::VectorXd& inertia) const
{
    const auto largest = [&](const Eigen::VectorXd& v) { return model_.map().largest(v); };
    return std::max({largest(forces_np1_.internal), largest(forces_np1_.interface), largest(forces_np1_.loads),
                     largest(forces_np1_.gravity), largest(forces_np1_.contact), largest(inertia)});
}

void SolidStep::factorise(const Motion& motion, double dt)
{
    Matrix matrix = model_.tangent(
        motion, {hht_.acceleration_slope(dt), 1 + hht_.alpha(), hht_.velocity_slope(dt), 1.0, time_ + dt});
    supports_.clear(matrix, matrix.diagonal().mean());
    solver_->factorise(matrix);
    factorised_dt_ = dt;
}

/// Adds the correction, halved until no element is turned inside out (det F > 0 everywhere). False when none helps.
bool SolidStep::apply(Motion& motion, const Eigen::VectorXd& correction, double dt)
{
    ++iterations_;
    double scale = 1;
    hht_.correct(motion, correction, scale, dt);
    for (int halvings = 0; !evaluate(motion, dt); ++halvings) {
        if (halvings == max_halvings || std::isinf(model_.map().largest(correction))) return false;
        scale *= 0.5;
        hht_.correct(motion, correction, -scale, dt);
    }
    return true;
}

std::string SolidStep::failure_text(const Motion& motion, double dt) const
{
    return base::text("the solid's step ", steps_ + 1, " from t = ", time_, " s, dt = ", dt, " s, ",
                      describe(failure_, mesh_, motion, newton_));
}

} // namespace fem

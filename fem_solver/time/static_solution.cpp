// SPDX-License-Identifier: MIT
#include "fem_solver/time/static_solution.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace fem {
namespace {

constexpr int max_load_halvings = 12;
/// Part of a load step below which its strides are not cut further.
constexpr double shortest_stride = 1.0 / 64;
/// A correction beyond this many times the body's size means that nothing holds the body.
constexpr double unheld = 1e6;

const char* advice(Failure::Kind kind)
{
    if (kind == Failure::Kind::unheld) return "Add supports, or springs, that hold the body";
    if (kind == Failure::Kind::unsettled)
        return "Try a larger penalty_factor, more load_steps, a finer mesh, or more max_augmentations";
    if (kind == Failure::Kind::not_a_number) return "Check the formulas of the loads, the moduli and the density";
    return "Check supports and loads, raise the load in more steps ([analysis] load_steps), or refine the mesh there";
}

} // namespace

StaticSolution::StaticSolution(const Mesh& mesh, const SolidForces& forces, const Supports& supports,
                               const StaticSettings& settings)
    : mesh_(mesh),
      model_(forces),
      supports_(supports),
      newton_(settings.newton, forces.map()),
      solver_(make_linear_solver(settings.solver, mesh, forces.map(), forces.pattern().zero())),
      forces_now_(Forces::zero(forces.dofs())),
      time_(settings.time),
      works_(forces, supports),
      size_(forces.map().largest(
          Eigen::Map<const Eigen::VectorXd>(mesh.coordinates.data(), std::ssize(mesh.coordinates))))
{}

void StaticSolution::solve(Motion& motion, int load_steps, const Observer& observer)
{
    model_.evaluate(motion, 0, forces_now_, time(0));
    works_.start(motion, forces_now_);
    for (int step = 1; step <= load_steps; ++step) {
        raise(motion, step, load_steps);
        observer(static_cast<double>(step) / load_steps);
    }
}

/// Raises the load by one load step, in halves of halves where one stride is too long.
void StaticSolution::raise(Motion& motion, int step, int load_steps)
{
    const double whole = 1.0 / load_steps, end = static_cast<double>(step) / load_steps;
    double stride = whole;
    for (double reached = end - whole; reached < end;) {
        const double next = end - reached <= stride * (1 + 1e-9) ? end : reached + stride;
        const Eigen::VectorXd start = motion.displacement;
        if (equilibrate(motion, next)) {
            works_.account(motion, forces_now_);
            reached = next;
            if (easy()) stride = std::min(2 * stride, whole);
            continue;
        }
        const std::string what =
            base::text("the static solution's stride from load factor ", reached, " to ", next, " (load step ", step,
                       " of ", load_steps, ") ", describe(failure_, mesh_, motion, newton_));
        if (stride <= whole * shortest_stride)
            throw base::Error(base::ExitCode::numerical_failure, what + ". " + advice(failure_.kind));
        report_(what + "; half of it is tried");
        motion.displacement = start;
        stride *= 0.5;
    }
}

/// Equilibrium at one load factor, with what the body touches; false, with the failure noted, when there is none.
bool StaticSolution::equilibrate(Motion& motion, double factor)
{
    model_.contact().restore();
    for (Augmentation contact = Augmentation::again; contact != Augmentation::settled;) {
        if (!solve(motion, factor)) return false;
        contact = model_.contact().augment(motion, time(factor));
        if (contact == Augmentation::unsettled)
            return fails({Failure::Kind::unsettled, {}, -1, model_.contact().complaint()});
    }
    model_.accept(motion, time(factor));
    return true;
}

/// Full Newton; false, with the failure noted, when it leads nowhere. The first correction takes moved supports to their
/// place and the body along.
bool StaticSolution::solve(Motion& motion, double factor)
{
    newton_.start();
    if (const auto inversion = model_.evaluate(motion, factor, forces_now_, time(factor)); inversion.happened())
        return fails({Failure::Kind::inversion, inversion});
    Eigen::VectorXd gap = supports_.gap(time(factor), motion.displacement);
    for (;;) {
        Eigen::VectorXd residual = forces_now_.unbalanced();
        const double scale = std::max(model_.map().largest(residual), model_.map().largest(forces_now_.internal));
        supports_.clear_rows(residual);
        const bool there = model_.map().largest(gap) == 0;
        if (newton_.converged(residual, scale, model_.round_off(motion)) && there) return true;
        if (newton_.broken()) return fails({Failure::Kind::not_a_number});
        if (newton_.exhausted()) return fails({Failure::Kind::no_convergence});
        Matrix matrix = model_.tangent(motion, {0.0, 1.0, 0.0, factor, time(factor)});
        if (!there) residual += matrix * gap;
        supports_.clear_rows(residual);
        supports_.clear(matrix, matrix.diagonal().mean());
        if (!factorise(matrix) || !apply(motion, gap - solver_->solve(residual), factor)) return false;
        if (!there && model_.map().largest(supports_.gap(time(factor), motion.displacement)) > 1e-12)
            return false; // cut on the way
        gap.setZero();
    }
}

bool StaticSolution::factorise(const Matrix& matrix)
{
    try {
        solver_->factorise(matrix);
    } catch (const base::Error&) {
        return fails({Failure::Kind::unheld});
    }
    return true;
}

bool StaticSolution::apply(Motion& motion, const Eigen::VectorXd& correction, double factor)
{
    const DofMap::Largest farthest = model_.map().find_largest(correction);
    if (!(farthest.value < unheld * size_)) {
        const int node = farthest.entry < 0 ? -1 : static_cast<int>(farthest.entry) / mesh_.dimension;
        return fails({Failure::Kind::unheld, {}, node});
    }
    double scale = 1;
    motion.displacement += correction;
    for (int halvings = 0;; ++halvings) {
        const Inversion inversion = model_.evaluate(motion, factor, forces_now_, time(factor));
        if (!inversion.happened()) return true;
        failure_ = {Failure::Kind::inversion, inversion};
        if (halvings == max_load_halvings) return false;
        scale *= 0.5;
        motion.displacement -= scale * correction;
    }
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/time/static_solution.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace fem {
namespace {

constexpr int max_halvings = 12;
/// Part of a load step below which its strides are not cut further.
constexpr double shortest_stride = 1.0 / 64;
/// A correction beyond this many times the body's size means that nothing holds the body.
constexpr double unheld = 1e6;

} // namespace

StaticSolution::StaticSolution(const Mesh& mesh, const SolidForces& forces, const Supports& supports,
                               const NewtonSettings& newton)
    : mesh_(mesh), model_(forces), supports_(supports), newton_(newton), forces_now_(Forces::zero(forces.dofs()))
{}

void StaticSolution::solve(Motion& motion, int load_steps, const Observer& observer)
{
    for (int step = 1; step <= load_steps; ++step) {
        raise(motion, static_cast<double>(step - 1) / load_steps, static_cast<double>(step) / load_steps);
        observer(static_cast<double>(step) / load_steps);
    }
}

/// Raises the load from one factor to another, in halves of halves where one stride is too long.
void StaticSolution::raise(Motion& motion, double from, double to)
{
    double stride = to - from;
    for (double reached = from; reached < to;) {
        const double next = to - reached <= stride * (1 + 1e-9) ? to : reached + stride;
        const Eigen::VectorXd start = motion.displacement;
        if (equilibrate(motion, next)) {
            reached = next;
            continue;
        }
        if (stride <= (to - from) * shortest_stride) fail(motion, next);
        motion.displacement = start;
        stride *= 0.5;
    }
}

/// Full Newton at one load factor; false, with the reason noted, when it leads nowhere. The first correction takes
/// moved supports to their place and the body along.
bool StaticSolution::equilibrate(Motion& motion, double factor)
{
    newton_.start();
    reason_ = "turns elements inside out";
    if (model_.evaluate(motion, factor, forces_now_, factor).happened()) return false;
    Eigen::VectorXd gap = supports_.gap(factor, motion.displacement);
    for (;;) {
        Eigen::VectorXd residual = forces_now_.unbalanced();
        const double scale = std::max(residual.cwiseAbs().maxCoeff(), forces_now_.internal.cwiseAbs().maxCoeff());
        supports_.clear_rows(residual);
        const bool there = gap.isZero(0);
        if (newton_.converged(residual, scale, model_.round_off(motion)) && there) return true;
        reason_ = "did not converge";
        if (newton_.exhausted()) return false;
        Matrix matrix = model_.tangent(motion, {0.0, 1.0, 0.0, factor, factor});
        if (!there) residual += matrix * gap;
        supports_.clear_rows(residual);
        supports_.clear(matrix, matrix.diagonal().mean());
        solver_.factorise(matrix);
        if (!apply(motion, gap - solver_.solve(residual), factor)) return false;
        if (!there && !supports_.gap(factor, motion.displacement).isZero(1e-12)) return false; // cut on the way
        gap.setZero();
    }
}

bool StaticSolution::apply(Motion& motion, const Eigen::VectorXd& correction, double factor)
{
    const double size = Eigen::Map<const Eigen::VectorXd>(mesh_.coordinates.data(), std::ssize(mesh_.coordinates))
                            .cwiseAbs()
                            .maxCoeff();
    reason_ = "has a singular matrix (do the supports hold the body against every rigid motion?)";
    if (!(correction.cwiseAbs().maxCoeff() < unheld * size)) return false; // NaN too
    double scale = 1;
    motion.displacement += correction;
    reason_ = "turns elements inside out";
    for (int halvings = 0; model_.evaluate(motion, factor, forces_now_, factor).happened(); ++halvings) {
        if (halvings == max_halvings) return false;
        scale *= 0.5;
        motion.displacement -= scale * correction;
    }
    return true;
}

void StaticSolution::fail(const Motion& motion, double factor) const
{
    const int node = static_cast<int>(newton_.worst()) / mesh_.dimension;
    std::string displaced;
    for (int k = 0; k < mesh_.dimension; ++k)
        displaced += base::text(k > 0 ? ", " : "", motion.displacement[node * mesh_.dimension + k]);
    const double residual = newton_.residuals().empty() ? 0 : newton_.residuals().back();
    throw base::Error(base::ExitCode::numerical_failure,
                      base::text("the static solution ", reason_, " at load factor ", factor, ": after ",
                                 newton_.residuals().size(), " iterations the largest residual is ", residual,
                                 " N at node ", node, ", reference position ", mesh_.describe_node(node),
                                 " m, displacement (", displaced,
                                 ") m. Check supports and loads, or raise the load in more steps"));
}

} // namespace fem

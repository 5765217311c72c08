// SPDX-License-Identifier: MIT
#include "fem_solver/time/static_solution.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace fem {
namespace {

constexpr int max_halvings = 12;
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
        const double factor = static_cast<double>(step) / load_steps;
        equilibrate(motion, factor);
        observer(factor);
    }
}

void StaticSolution::equilibrate(Motion& motion, double factor)
{
    model_.evaluate(motion, factor, forces_now_);
    for (newton_.start();;) {
        Eigen::VectorXd residual = forces_now_.unbalanced();
        const double scale = std::max(residual.cwiseAbs().maxCoeff(), forces_now_.internal.cwiseAbs().maxCoeff());
        supports_.clear_rows(residual);
        if (newton_.converged(residual, scale, model_.round_off())) break;
        if (newton_.exhausted()) fail(motion, factor, "did not converge");
        Matrix matrix = model_.tangent(motion, {0.0, 1.0, 0.0, factor});
        supports_.clear(matrix, matrix.diagonal().mean());
        solver_.factorise(matrix);
        apply(motion, solver_.solve(-residual), factor);
    }
}

void StaticSolution::apply(Motion& motion, const Eigen::VectorXd& correction, double factor)
{
    const double size = Eigen::Map<const Eigen::VectorXd>(mesh_.coordinates.data(), std::ssize(mesh_.coordinates))
                            .cwiseAbs()
                            .maxCoeff();
    if (!(correction.cwiseAbs().maxCoeff() < unheld * size)) // NaN too
        fail(motion, factor, "has a singular matrix; do the supports hold the body against every rigid motion? It");
    double scale = 1;
    motion.displacement += correction;
    for (int halvings = 0; model_.evaluate(motion, factor, forces_now_).happened(); ++halvings) {
        if (halvings == max_halvings) fail(motion, factor, "turns elements inside out, whatever the step, and");
        scale *= 0.5;
        motion.displacement -= scale * correction;
    }
}

void StaticSolution::fail(const Motion& motion, double factor, const std::string& what) const
{
    const int node = static_cast<int>(newton_.worst()) / mesh_.dimension;
    std::string displaced;
    for (int k = 0; k < mesh_.dimension; ++k)
        displaced += base::text(k > 0 ? ", " : "", motion.displacement[node * mesh_.dimension + k]);
    throw base::Error(base::ExitCode::numerical_failure,
                      base::text("the static solution at load factor ", factor, " ", what, " stopped after ",
                                 newton_.residuals().size(), " iterations: largest residual ",
                                 newton_.residuals().back(), " N at node ", node, ", reference position ",
                                 mesh_.describe_node(node), " m, displacement (", displaced,
                                 ") m. Try more load steps, and check supports and loads"));
}

} // namespace fem

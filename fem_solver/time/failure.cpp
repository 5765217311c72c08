// SPDX-License-Identifier: MIT
#include "fem_solver/time/failure.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <cmath>

namespace fem {
namespace {

std::string place(const Mesh& mesh, const Motion& motion, int node)
{
    std::string displaced;
    for (int k = 0; k < mesh.dimension; ++k)
        displaced += base::text(k > 0 ? ", " : "", motion.displacement[node * mesh.dimension + k]);
    return base::text("node ", node, ", reference position ", mesh.describe_node(node), " m, displacement (", displaced,
                      ") m");
}

} // namespace

int first_not_a_number(const Eigen::VectorXd& vector)
{
    for (Eigen::Index i = 0; i < vector.size(); ++i)
        if (!std::isfinite(vector[i])) return static_cast<int>(i);
    return -1;
}

std::string describe(const Failure& failure, const Mesh& mesh, const Motion& motion, const NewtonMonitor& newton)
{
    switch (failure.kind) {
    case Failure::Kind::inversion: {
        const int element = failure.inversion.element;
        const int node = mesh.connectivity[static_cast<std::size_t>(element) * mesh.nodes_per_element()];
        return base::text("turns element ", element, " inside out (det F = ", failure.inversion.determinant,
                          "), which holds ", place(mesh, motion, node));
    }
    case Failure::Kind::unheld:
        return "has a singular matrix: the supports do not hold the body against every rigid motion" +
               (failure.node < 0 ? "" : "; what moves farthest is " + place(mesh, motion, failure.node));
    case Failure::Kind::not_a_number:
        return "has forces that are not numbers at " + place(mesh, motion, failure.node);
    case Failure::Kind::no_convergence:
        break;
    }
    const double residual = newton.residuals().empty() ? 0 : newton.residuals().back();
    return base::text("did not converge in ", newton.residuals().size(), " iterations: largest residual ", residual,
                      " N at ", place(mesh, motion, static_cast<int>(newton.worst()) / mesh.dimension));
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/time/failure.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace fem {
namespace {

std::string place(const Mesh& mesh, const Motion& motion, int node)
{
    if (node < 0) return "";
    std::string displaced;
    for (int k = 0; k < mesh.dimension; ++k)
        displaced += base::text(k > 0 ? ", " : "", motion.displacement[node * mesh.dimension + k]);
    return base::text("node ", mesh.node_id(node), ", reference position ", mesh.describe_node(node),
                      " m, displacement (", displaced, ") m");
}

std::string inverted(const Inversion& inversion, const Mesh& mesh, const Motion& motion)
{
    if (inversion.element < 0) return "";
    const int node = mesh.connectivity[static_cast<std::size_t>(inversion.element) * mesh.nodes_per_element()];
    return base::text("turns element ", mesh.element_id(inversion.element),
                      " inside out (det F = ", inversion.determinant, "), which holds ", place(mesh, motion, node));
}

} // namespace

std::string describe(const Failure& failure, const Mesh& mesh, const Motion& motion, const NewtonMonitor& newton)
{
    const auto where = [&](Eigen::Index entry) {
        return mesh.team().first_text(place(mesh, motion, entry < 0 ? -1 : static_cast<int>(entry) / mesh.dimension));
    };
    switch (failure.kind) {
    case Failure::Kind::inversion:
        return mesh.team().first_text(inverted(failure.inversion, mesh, motion));
    case Failure::Kind::unheld: {
        const std::string farthest = mesh.team().first_text(place(mesh, motion, failure.node));
        return "has a singular matrix: the supports do not hold the body against every rigid motion" +
               (farthest.empty() ? "" : "; what moves farthest is " + farthest);
    }
    case Failure::Kind::unsettled:
        return failure.complaint;
    case Failure::Kind::not_a_number:
        return "has forces that are not numbers at " + where(newton.worst());
    case Failure::Kind::no_convergence:
        break;
    }
    const double residual = newton.residuals().empty() ? 0 : newton.residuals().back();
    return base::text("did not converge in ", newton.residuals().size(), " iterations: largest residual ", residual,
                      " N at ", where(newton.worst()));
}

} // namespace fem

// SPDX-License-Identifier: MIT
// Torsion of a rubber cylinder by a right angle, its length kept (R. S. Rivlin, Phil. Trans. R. Soc. A 242 (1949) 173):
//
//     M = mu pi psi a^4 / 2,     N = - mu pi psi^2 a^4 / 4,     psi = turn per length
#include "fem_solver/mesh/block_mesh.hpp"
#include "fem_solver/time/static_solution.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;

constexpr double mu = 4e6, radius = 0.005, length = 0.02, turn = M_PI / 2;

/// A square of cells made round: rings of the square become circles towards the rim.
Mesh cylinder(ElementType type, std::vector<int> cells)
{
    Mesh mesh = make_block({type, {-1, -1, 0}, {1, 1, length}, std::move(cells)});
    for (int i = 0; i < mesh.nodes(); ++i) {
        const double x = mesh.node(i)[0], y = mesh.node(i)[1];
        mesh.coordinates[3 * i] = radius * x * std::sqrt(1 - y * y / 2);
        mesh.coordinates[3 * i + 1] = radius * y * std::sqrt(1 - x * x / 2);
    }
    return mesh;
}

struct Twist {
    double moment = 0, force = 0;
};

Twist twist(ElementType type, std::vector<int> cells)
{
    const Mesh mesh = cylinder(type, std::move(cells));
    const double bulk = 2000 * mu;
    const SolidForces forces(mesh, {NeoHookean{Lame{mu, bulk - 2 * mu / 3}}, 1000}, {false, Formulation::mixed});
    Supports supports(mesh);
    supports.fix("back", {"x", "y", "z"});
    const auto still = [](double) { return base::TimeValue{}; };
    supports.drive("front",
                   std::make_shared<RigidDrive>(Eigen::Vector3d(0, 0, length), Eigen::Vector3d(0, 0, 1),
                                                std::array<base::TimeFunction, 3>{still, still, still}, [](double t) {
                                                    return base::TimeValue{turn * t, turn, 0};
                                                }));
    StaticSolution solution(mesh, forces, supports, {1e-9, 30, 0.1});
    Motion motion = Motion::at_rest(forces.dofs());
    solution.solve(motion, 4, [](double) {});
    const Eigen::VectorXd f = solution.reaction();
    return {supports.moment(supports.driven().front(), 1, motion, f)[2], supports.reaction("front", f)[2]};
}

TEST(Torsion, MomentAndNormalForceOfRivlin)
{
    const Twist solid = twist(ElementType::hexa27, {2, 2, 3});
    EXPECT_NEAR(solid.moment / 0.308425, 1, 0.01);
    EXPECT_NEAR(solid.force / -12.1118, 1, 0.01);
}

} // namespace

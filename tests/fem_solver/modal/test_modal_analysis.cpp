// SPDX-License-Identifier: MIT
// Natural frequencies against exact answers, on any number of ranks.
#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/assembly/pressure_load.hpp"
#include "fem_solver/mesh/block_mesh.hpp"
#include "fem_solver/modal/modal_analysis.hpp"
#include "tests/fem_solver/support/distributed.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace fem;

/// A block in the plane or in space with supports, shared by all ranks.
struct Block {
    Mesh mesh;
    SolidForces forces;
    Supports supports;

    Block(const BlockSpec& spec, const Law& law)
        : mesh(fem_test::distributed(make_block(spec))), forces(mesh, {law, 1100}, {}), supports(mesh)
    {}
    std::vector<Mode> modes(int count, double load_factor = 0) const
    {
        return find_modes(mesh, forces, supports, Motion::at_rest(forces.dofs()), load_factor, count);
    }
};

Law elastic(double nu) { return SmallElastic{Lame::from_young(12e6, nu)}; }

/// Axial vibrations of a bar, one end held: f_k = (2k - 1)/(4 L) sqrt(E/rho).
TEST(Modes, OfABarAlongItself)
{
    Block bar({ElementType::quad8, {0, 0}, {0.1, 0.01}, {20, 2}}, elastic(0));
    bar.supports.fix("left", {"x"});
    for (const char* side : {"bottom", "top", "left", "right"}) bar.supports.fix(side, {"y"});
    const auto modes = bar.modes(3);
    for (int k = 0; k < 3; ++k) {
        const double exact = (2 * k + 1) / 0.4 * std::sqrt(12e6 / 1100);
        EXPECT_NEAR(modes[k].frequency() / exact, 1, 2e-5) << "mode " << k;
        EXPECT_LT(modes[k].residual, 1e-10);
        const double share = 8 / std::pow((2 * k + 1) * M_PI, 2); // of the bar's mass
        EXPECT_NEAR(modes[k].masses[0] / (1100 * 0.1 * 0.01), share, 1e-4);
    }
}

/// A free body moves as it likes: three rigid motions in the plane, six in space, the rest far above.
TEST(Modes, OfAFreeBodyBeginWithItsRigidMotions)
{
    const auto plane = Block({ElementType::quad4, {0, 0}, {0.1, 0.02}, {10, 2}}, elastic(0.3)).modes(4);
    for (int k = 0; k < 3; ++k) EXPECT_LT(plane[k].frequency(), 1e-4 * plane[3].frequency());
    double mass = 0;
    for (int k = 0; k < 3; ++k) mass += plane[k].masses[0];
    EXPECT_NEAR(mass, 1100 * 0.1 * 0.02, 1e-6);

    const auto space = Block({ElementType::hexa8, {0, 0, 0}, {0.1, 0.02, 0.02}, {8, 2, 2}}, elastic(0.3)).modes(7);
    for (int k = 0; k < 6; ++k) EXPECT_LT(space[k].frequency(), 1e-4 * space[6].frequency());
}

/// Shapes are orthonormal in the mass, and all modes together take part with the mass that is not held.
TEST(Modes, AreOrthonormalAndCarryTheMass)
{
    Block block({ElementType::quad4, {0, 0}, {0.1, 0.02}, {4, 1}}, elastic(0.3));
    block.supports.fix("left", {"x", "y"});
    const auto modes = block.modes(15);
    const DofMap& dofs = block.forces.map();
    double mass = 0;
    for (const Mode& a : modes) {
        mass += a.masses[1];
        for (const Mode& b : modes)
            EXPECT_NEAR(dofs.dot(a.shape, block.forces.inertia(b.shape)), &a == &b ? 1 : 0, 1e-8);
    }
    EXPECT_LT(mass, 1100 * 0.1 * 0.02);
    EXPECT_GT(mass, 0.8 * 1100 * 0.1 * 0.02);
}

/// A follower pressure whose edge is free is no conservative load: its tangent has two halves.
TEST(Modes, OfALoadedStateTakeFollowerLoadsAlong)
{
    Block block({ElementType::quad8, {0, 0}, {0.1, 0.005}, {20, 2}}, NeoHookean{Lame::from_young(12e6, 0.3)});
    block.supports.fix("left", {"x", "y"});
    block.forces.add_load(make_follower_pressure(block.mesh, block.forces.pattern(), block.mesh.faces("top"),
                                                 [](const double*) { return 1e4; }));
    const Motion still = Motion::at_rest(block.forces.dofs());
    EXPECT_GT(asymmetry(block.forces, still), 1e-6); // the pressure's edge is free
    EXPECT_NE(block.modes(1, 1)[0].frequency(), block.modes(1, 0)[0].frequency());
}

/// A clamped column under so many times Euler's strain, pi^2 h^2/(48 L^2). Exact for a slender beam, EI y'''' + P y'' = rho A w^2 y
/// with the force P kept upright (EI y''' + P y' = 0 at the end): w^2/w_1^2, from the roots of the characteristic determinant.
TEST(Modes, OfABuckledColumnAreNegative)
{
    const double length = 0.1, thickness = 0.005;
    Block column({ElementType::quad8, {0, 0}, {length, thickness}, {20, 2}},
                 SaintVenantKirchhoff{Lame::from_young(12e6, 0)});
    column.supports.fix("left", {"x", "y"});
    const auto lowest = [&](double load, int count) {
        Motion state = Motion::at_rest(column.forces.dofs());
        const double strain = load * M_PI * M_PI / 48 * std::pow(thickness / length, 2);
        for (int i = 0; i < column.mesh.nodes(); ++i) state.displacement[2 * i] = -strain * column.mesh.node(i)[0];
        const double w = find_modes(column.mesh, column.forces, column.supports, state, 0, count)[0].angular_frequency;
        return std::copysign(w * w, w);
    };
    const double free = lowest(0, 1);
    EXPECT_GT(lowest(0.95, 1), 0);
    EXPECT_LT(lowest(1.05, 1), 0);
    const std::pair<double, double> exact[] = {{0.5, 0.519641}, {2.0, -1.210036}, {20.0, -195.600}};
    for (const auto& [load, square] : exact) { // the last far below the first shift
        EXPECT_NEAR(lowest(load, 2) / free / square, 1, 0.01) << load;
        EXPECT_NEAR(lowest(load, 1) / lowest(load, 2), 1, 1e-6) << load; // asked for alone it is still the lowest
    }
}

TEST(Modes, AskedForAreThere)
{
    Block block({ElementType::quad4, {0, 0}, {0.1, 0.02}, {4, 1}}, elastic(0.3));
    block.supports.fix("left", {"x", "y"});
    std::string message;
    try {
        block.modes(16);
    } catch (const base::Error& error) {
        message = error.what();
    }
    EXPECT_NE(message.find("16"), std::string::npos) << message;
}

} // namespace

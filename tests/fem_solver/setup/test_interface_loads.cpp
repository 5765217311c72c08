// SPDX-License-Identifier: MIT
#include "fem_solver/interface/wet_boundary.hpp"
#include "fem_solver/mesh/block_mesh.hpp"
#include "fem_solver/setup/interface_loads.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;

class Wet : public testing::Test {
protected:
    Mesh mesh_ = make_block({ElementType::quad8, {0, 0}, {1, 2}, {1, 2}});
    WetBoundary boundary_{mesh_, {"left", "bottom"}};
    SolidForces forces_{mesh_, {NeoHookean{Lame::from_young(1e6, 0.3)}, 1000}, {}};
    Motion motion_ = Motion::at_rest(forces_.dofs());

    Forces evaluate()
    {
        Forces forces = Forces::zero(forces_.dofs());
        forces_.evaluate(motion_, 1, forces);
        return forces;
    }
};

TEST_F(Wet, RegistersFacetsOnTheElementsOwnNodes)
{
    const coupler::WetSurface surface = boundary_.surface();
    ASSERT_EQ(surface.facet_ids.size(), 6u); // two segments for each of three edges
    EXPECT_EQ(surface.node_ids.size(), 7u);
    for (const auto& facet : surface.facet_nodes) {
        const double* a = surface.reference.data() + 2 * facet[0];
        const double* b = surface.reference.data() + 2 * facet[1];
        const double normal_x = b[1] - a[1], normal_y = a[0] - b[0];
        const bool bottom = a[1] == 0 && b[1] == 0;
        EXPECT_EQ(normal_x < 0, !bottom); // out of the body: down on the bottom, left on the left
        EXPECT_EQ(normal_y < 0, bottom);
    }
}

TEST_F(Wet, SpreadIsTheReverseOfGather)
{
    std::vector<double> values(2 * boundary_.surface_nodes().size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
    EXPECT_EQ(boundary_.gather(boundary_.spread(values)), values);
    EXPECT_EQ(boundary_.spread(values).sum(), 91);
}

TEST_F(Wet, ConservativeForcesArriveAtTheirNodesWithForceMomentAndPower)
{
    InterfaceLoads loads(mesh_, boundary_, forces_, {false, 0});
    coupler::SurfaceLoad load;
    load.force.resize(14);
    for (int i = 0; i < 14; ++i) load.force[i] = std::sin(i + 1.0);
    loads.start(load);
    motion_.displacement.setConstant(0.1);
    const Eigen::VectorXd force = evaluate().interface;
    EXPECT_EQ(boundary_.gather(force), load.force);
    const Resultants sum = resultants(mesh_, motion_, force);
    double fx = 0, moment = 0;
    const auto position = boundary_.motion(motion_).position;
    for (int i = 0; i < 7; ++i) {
        fx += load.force[2 * i];
        moment += position[2 * i] * load.force[2 * i + 1] - position[2 * i + 1] * load.force[2 * i];
    }
    EXPECT_NEAR(sum.force[0], fx, 1e-14);
    EXPECT_NEAR(sum.moment[2], moment, 1e-14);
}

TEST_F(Wet, AveragedPressurePushesIntoTheBody)
{
    InterfaceLoads loads(mesh_, boundary_, forces_, {true, 0});
    coupler::SurfaceLoad load;
    load.pressure.assign(6, 10.0);
    loads.start(load);
    const Resultants sum = resultants(mesh_, motion_, evaluate().interface);
    EXPECT_NEAR(sum.force[0], 20, 1e-13); // left face, 2 m
    EXPECT_NEAR(sum.force[1], 10, 1e-13); // bottom face, 1 m
}

/// Only wet facets answer, to the change of velocity since the load was measured.
TEST_F(Wet, ImpedanceAnswersTheChangeOfVelocity)
{
    InterfaceLoads loads(mesh_, boundary_, forces_, {true, 0.5});
    coupler::SurfaceLoad load;
    load.impedance = 4;
    load.pressure.assign(6, 0.0);
    for (int f = 0; f < 6; ++f) load.pressure[f] = f % 2 ? 0.0 : 1.0; // half of each edge is wet
    load.wall_velocity.assign(14, 1.0);
    loads.start(load);
    loads.set(load, motion_);
    motion_.velocity.setConstant(1.0);
    EXPECT_NEAR(evaluate().correction.norm(), 0, 1e-14);
    motion_.velocity.setConstant(4.0);
    const Resultants sum = resultants(mesh_, motion_, evaluate().correction);
    EXPECT_NEAR(sum.force[0], -0.5 * 4 * 3 * 1.0, 1e-13); // factor, rho c, change, wet length
    EXPECT_NEAR(sum.force[1], -0.5 * 4 * 3 * 0.5, 1e-13);
}

} // namespace

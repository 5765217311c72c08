// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/block_mesh.hpp"
#include "fem_solver/output/probes.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using Names = std::vector<std::string>;

TEST(Probes, ColumnsNameQuantityAndUnit)
{
    const Mesh flat = make_block({ElementType::quad4, {0, 0}, {1, 1}, {2, 2}});
    const Mesh deep = make_block({ElementType::hexa8, {0, 0, 0}, {1, 1, 1}, {1, 1, 1}});
    EXPECT_EQ(Probes(flat, {{"a", {1, 1}, {"velocity", "load"}}}).columns(),
              (Names{"a.vx[m/s]", "a.vy[m/s]", "a.fx[N/m]", "a.fy[N/m]"}));
    EXPECT_EQ(Probes(deep, {{"b", {0, 0, 1}, {"displacement", "load"}}}).columns(),
              (Names{"b.ux[m]", "b.uy[m]", "b.uz[m]", "b.fx[N]", "b.fy[N]", "b.fz[N]"}));
}

TEST(Probes, ValuesAreThoseOfTheNearestNode)
{
    const Mesh mesh = make_block({ElementType::quad4, {0, 0}, {1, 1}, {2, 2}});
    Motion motion = Motion::at_rest(std::ssize(mesh.coordinates));
    Eigen::VectorXd load = motion.displacement;
    const int node = mesh.nearest_node({0.6, 0.4});
    motion.displacement.segment(2 * node, 2) << 3, 4;
    load.segment(2 * node, 2) << 5, 6;
    const Probes probes(mesh, {{"middle", {0.6, 0.4}, {"load", "displacement"}}, {"corner", {0, 0}, {"load"}}});
    EXPECT_EQ(probes.values(motion, load), (std::vector<double>{5, 6, 3, 4, 0, 0}));
}

} // namespace

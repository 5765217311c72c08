// SPDX-License-Identifier: MIT
// A mesh cut for several ranks, and vectors over it. Every rank runs every test: EXPECT_* only.
#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/dofs/dof_map.hpp"
#include "fem_solver/mesh/block_mesh.hpp"
#include "tests/fem_solver/support/distributed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace {

using namespace fem;

const std::vector<BlockSpec> blocks{{ElementType::quad8, {0, 0}, {3, 1}, {12, 5}},
                                    {ElementType::tri3, {0, 0}, {1, 1}, {6, 6}},
                                    {ElementType::hexa20, {0, 0, 0}, {2, 1, 1}, {6, 3, 3}},
                                    {ElementType::tet4, {0, 0, 0}, {1, 1, 1}, {4, 4, 4}}};

/// A field that every rank can compute for the whole body.
double value(const Mesh& mesh, int node, int component)
{
    const double* x = mesh.node(node);
    return std::sin(3 * x[0] + component) + x[1] * x[1] - (mesh.dimension == 3 ? x[2] : 0);
}

Eigen::VectorXd field(const Mesh& mesh)
{
    Eigen::VectorXd v(std::ssize(mesh.coordinates));
    for (int i = 0; i < mesh.nodes(); ++i)
        for (int k = 0; k < mesh.dimension; ++k) v[i * mesh.dimension + k] = value(mesh, i, k);
    return v;
}

TEST(CutMesh, GivesEveryNodeAndElementOneOwner)
{
    for (const BlockSpec& spec : blocks) {
        const Mesh whole = make_block(spec), mesh = fem_test::distributed(whole);
        std::vector<std::int64_t> nodes, elements;
        for (int i = 0; i < mesh.own_nodes(); ++i) nodes.push_back(mesh.node_id(i));
        for (int e = 0; e < mesh.own_elements(); ++e) elements.push_back(mesh.element_id(e));
        for (auto [ids, count] : {std::pair(mesh.team().gather_all(nodes), whole.nodes()),
                                  std::pair(mesh.team().gather_all(elements), whole.elements())}) {
            std::ranges::sort(ids);
            EXPECT_EQ(std::ssize(ids), count);
            for (std::int64_t i = 0; i < count && i < std::ssize(ids); ++i)
                EXPECT_EQ(ids[static_cast<std::size_t>(i)], i);
        }
        EXPECT_LE(mesh.own_elements(), 1.3 * whole.elements() / mesh.team().size());
        EXPECT_LE(mesh.own_nodes(), 1.3 * whole.nodes() / mesh.team().size());
    }
}

TEST(CutMesh, HoldsAllElementsAroundItsOwnNodesAsTheyAre)
{
    for (const BlockSpec& spec : blocks) {
        const Mesh whole = make_block(spec), mesh = fem_test::distributed(whole);
        const int n = whole.nodes_per_element();
        std::vector<int> around(static_cast<std::size_t>(whole.nodes()), 0);
        for (const int node : whole.connectivity) ++around[static_cast<std::size_t>(node)];
        std::vector<int> here(static_cast<std::size_t>(mesh.nodes()), 0);
        for (int e = 0; e < mesh.elements(); ++e)
            for (int a = 0; a < n; ++a) {
                const int node = mesh.connectivity[static_cast<std::size_t>(e * n + a)];
                const auto original = static_cast<std::size_t>(mesh.element_id(e) * n + a);
                EXPECT_EQ(mesh.node_id(node), whole.connectivity[original]);
                ++here[static_cast<std::size_t>(node)];
            }
        for (int i = 0; i < mesh.own_nodes(); ++i) {
            EXPECT_EQ(here[static_cast<std::size_t>(i)], around[static_cast<std::size_t>(mesh.node_id(i))]);
            for (int k = 0; k < mesh.dimension; ++k)
                EXPECT_EQ(mesh.node(i)[k], whole.node(static_cast<int>(mesh.node_id(i)))[k]);
        }
        std::int64_t faces = 0;
        for (const MeshFace& face : mesh.faces("right")) faces += face.element < mesh.own_elements() ? 1 : 0;
        EXPECT_EQ(mesh.team().sum(faces), std::ssize(whole.faces("right")));
    }
}

TEST(CutMesh, FindsTheNearestNodeOnItsOwner)
{
    const Mesh whole = make_block(blocks[0]), mesh = fem_test::distributed(whole);
    for (const std::vector<double>& point : {std::vector<double>{0.1, 0.9}, {2.9, 0.01}, {1.5, 0.5}}) {
        const int node = mesh.nearest_node(point);
        const bool own = node >= 0 && node < mesh.own_nodes();
        EXPECT_EQ(mesh.team().sum(own ? mesh.node_id(node) : std::int64_t{0}), whole.nearest_node(point));
        EXPECT_EQ(mesh.team().sum(std::int64_t{own}), 1);
    }
}

TEST(DofMap, SumsAndRefreshesAsIfTheBodyWereOnOneRank)
{
    for (const BlockSpec& spec : blocks) {
        const Mesh whole = make_block(spec), mesh = fem_test::distributed(whole);
        const DofMap alone(whole), dofs(mesh);
        const Eigen::VectorXd a = field(whole), b = field(mesh);
        EXPECT_NEAR(dofs.dot(b, b), alone.dot(a, a), 1e-12 * alone.dot(a, a));
        EXPECT_EQ(dofs.largest(b), alone.largest(a));
        EXPECT_EQ(dofs.find_largest(b).value, alone.find_largest(a).value);
        EXPECT_EQ(mesh.team().sum(std::int64_t{dofs.find_largest(b).entry >= 0}), 1);
        Eigen::VectorXd halo = b;
        halo.tail(halo.size() - dofs.own()).setConstant(1e9);
        dofs.refresh(halo);
        EXPECT_EQ(halo, b);
    }
}

TEST(DofMap, NumbersEquationsOnce)
{
    const Mesh mesh = fem_test::distributed(make_block(blocks[1]));
    const DofMap dofs(mesh);
    const auto& all = dofs.equations();
    auto own = mesh.team().gather_all(std::vector<std::int64_t>(all.begin(), all.begin() + dofs.own()));
    for (std::size_t i = 0; i < own.size(); ++i) EXPECT_EQ(own[i], static_cast<std::int64_t>(i));
    EXPECT_EQ(std::set<std::int64_t>(all.begin(), all.end()).size(), all.size());
}

TEST(DofMap, SaysThatAnEntryIsNoNumberOnAllRanks)
{
    const Mesh mesh = fem_test::distributed(make_block(blocks[0]));
    const DofMap dofs(mesh);
    Eigen::VectorXd v = field(mesh);
    if (mesh.team().rank() == mesh.team().size() - 1) v[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isinf(dofs.largest(v)));
    const DofMap::Largest worst = dofs.find_largest(v);
    EXPECT_TRUE(std::isinf(worst.value));
    if (mesh.team().rank() == mesh.team().size() - 1) EXPECT_EQ(worst.entry, 3);
}

TEST(Partition, SaysWhenThereAreTooFewElements)
{
    const Mesh mesh = make_block({ElementType::quad4, {0, 0}, {1, 1}, {1, 2}});
    std::string message;
    try {
        partition_elements(mesh, element_work(mesh, {}), 3);
    } catch (const base::Error& error) {
        message = error.what();
    }
    EXPECT_NE(message.find("2 elements"), std::string::npos) << message;
}

TEST(Partition, CountsLoadedFaces)
{
    const Mesh mesh = make_block({ElementType::quad4, {0, 0}, {1, 1}, {2, 2}});
    const auto work = element_work(mesh, {"left", "bottom"});
    EXPECT_EQ(std::ranges::count(work, 6), 1);
    EXPECT_EQ(std::ranges::count(work, 5), 2);
    EXPECT_EQ(std::ranges::count(work, 4), 1);
}

} // namespace

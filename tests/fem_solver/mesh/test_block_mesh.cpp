// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/mesh/block_mesh.hpp"
#include "fem_solver/mesh/linear_facets.hpp"
#include "tests/fem_solver/support/enclosed.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace fem;
using fem_test::enclosed;

Mesh gate(ElementType type) { return make_block({type, {0.1, 0.0}, {0.105, 0.079}, {4, 40}}); }

TEST(BlockMesh, CountsNodesAndElements)
{
    EXPECT_EQ(gate(ElementType::quad4).nodes(), 5 * 41);
    EXPECT_EQ(gate(ElementType::quad8).nodes(), 9 * 81 - 4 * 40);
    EXPECT_EQ(gate(ElementType::quad8).elements(), 160);
    const Mesh box = make_block({ElementType::hexa20, {0, 0, 0}, {1, 1, 1}, {2, 1, 1}});
    EXPECT_EQ(box.nodes(), 32); // two elements of 20 that share a face of 8
    EXPECT_EQ(box.faces("all").size(), 10u);
    check_jacobians(box);
}

TEST(BlockMesh, GroupsLieOnTheirSides)
{
    const Mesh mesh = gate(ElementType::quad8);
    for (const int node : mesh.group_nodes("left")) EXPECT_DOUBLE_EQ(mesh.node(node)[0], 0.1);
    for (const int node : mesh.group_nodes("top")) EXPECT_DOUBLE_EQ(mesh.node(node)[1], 0.079);
    EXPECT_EQ(mesh.group_nodes("left").size(), 81u);
    EXPECT_EQ(mesh.faces("bottom").size(), 4u);
    EXPECT_EQ(static_cast<int>(mesh.group_nodes("all").size()), mesh.nodes());
    EXPECT_EQ(mesh.nearest_node({0.1025, 0.0}), 4);
}

/// The divergence theorem over the facets gives the area of the block: all normals (t_y, -t_x) point outward.
TEST(BlockMesh, FacetsKeepTheBodyOnTheLeft)
{
    for (const ElementType type : {ElementType::quad4, ElementType::quad8}) {
        const Mesh mesh = gate(type);
        const auto facets = linear_facets(mesh, mesh.faces("all"));
        EXPECT_EQ(facets.size(), type == ElementType::quad8 ? 176u : 88u);
        double area = 0;
        for (const auto& facet : facets) {
            const double *a = mesh.node(facet[0]), *b = mesh.node(facet[1]);
            area += 0.5 * (0.5 * (a[0] + b[0]) * (b[1] - a[1]) - 0.5 * (a[1] + b[1]) * (b[0] - a[0]));
        }
        EXPECT_NEAR(area, 0.005 * 0.079, 1e-15);
    }
}

/// Whatever the elements: none is turned inside out, and their faces' linear parts close around the block.
TEST(BlockMesh, EveryElementFillsTheBlock)
{
    for (const auto& [type, name] : element_names) {
        const int d = dimension_of(type);
        std::vector<double> high{1, 2, 3};
        std::vector<int> cells{2, 3, 2};
        high.resize(d);
        cells.resize(d);
        const Mesh mesh = make_block({type, std::vector<double>(d, 0.0), high, cells});
        check_jacobians(mesh);
        EXPECT_NEAR(enclosed(mesh, linear_facets(mesh, mesh.faces("all"))), d == 2 ? 2 : 6, 1e-13) << name;
        for (const int node : mesh.group_nodes("top")) EXPECT_EQ(mesh.node(node)[1], 2) << name;
        std::vector<char> used(mesh.nodes(), 0);
        for (const int node : mesh.connectivity) used[node] = 1;
        EXPECT_EQ(std::ranges::count(used, 0), 0) << name; // no node without an element
    }
}

template<class Action> std::string message_of(Action&& action)
{
    try {
        action();
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::bad_input);
        return error.what();
    }
    return "no error";
}

TEST(BlockMesh, NamesWhatIsWrong)
{
    const Mesh mesh = gate(ElementType::quad4);
    EXPECT_EQ(message_of([&] { mesh.faces("wet"); }),
              "the mesh has no group 'wet'; its groups are: all, bottom, left, right, top");
    EXPECT_NE(message_of([] {
                  make_block({ElementType::quad4, {1, 0}, {0, 1}, {1, 1}});
              }).find("low[0] = 1 m must be below"),
              std::string::npos);
    EXPECT_NE(message_of([] {
                  make_block({ElementType::hexa8, {0, 0}, {1, 1}, {1, 1}});
              }).find("3 entries each"),
              std::string::npos);
    Mesh inside_out = gate(ElementType::quad4);
    std::swap(inside_out.connectivity[0], inside_out.connectivity[1]);
    EXPECT_NE(message_of([&] { check_jacobians(inside_out); }).find("element 0 (quad4)"), std::string::npos);
}

} // namespace

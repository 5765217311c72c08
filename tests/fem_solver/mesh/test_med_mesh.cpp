// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/linear_facets.hpp"
#include "fem_solver/mesh/med_mesh.hpp"
#include "tests/fem_solver/support/distorted_block.hpp"
#include "tests/fem_solver/support/enclosed.hpp"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace fem;
using fem_test::enclosed;
using fem_test::LinearShape;

Mesh read(ElementType type)
{
    return read_med_mesh({std::string(RIVAGE_TEST_DATA) + "/" + name_of(type) + ".med", "", dimension_of(type)});
}

class MedMesh : public testing::TestWithParam<ElementType> {};

/// Gmsh's edges are straight here: each node lies where the corners' own interpolation puts the place that our shape gives
/// it. A node out of order would not; nor would corners, since the mesh is read only where all Jacobians are positive.
TEST_P(MedMesh, HasItsNodesInOurOrder)
{
    const Mesh mesh = read(GetParam());
    EXPECT_EQ(mesh.type, GetParam());
    with_shape(mesh.type, [&](auto shape) {
        using Shape = decltype(shape);
        constexpr int D = Shape::dimension;
        using Corners = LinearShape<D, is_simplex<Shape>>::type;
        for (int e = 0; e < mesh.elements(); ++e)
            for (int a = 0; a < Shape::nodes; ++a) {
                const int* nodes = mesh.connectivity.data() + e * Shape::nodes;
                Eigen::Matrix<double, D, 1> xi;
                for (int k = 0; k < D; ++k) xi[k] = Shape::corners[a][k];
                const auto weights = Corners::values(xi);
                for (int k = 0; k < D; ++k) {
                    double expected = 0;
                    for (int c = 0; c < Corners::nodes; ++c) expected += weights[c] * mesh.node(nodes[c])[k];
                    EXPECT_NEAR(mesh.node(nodes[a])[k], expected, 1e-8) << "element " << e << " node " << a;
                }
            }
    });
}

/// Area of the flat mesh by its corners; the box is that pushed by 0.6 along z.
double exact_content(int dimension)
{
    const double x[] = {0, 1, 1.1, -0.05}, y[] = {0, 0.05, 0.8, 0.7};
    double area = 0;
    for (int a = 0; a < 4; ++a) area += 0.5 * (x[a] * y[(a + 1) % 4] - x[(a + 1) % 4] * y[a]);
    return dimension == 2 ? area : 0.6 * area;
}

TEST_P(MedMesh, HasSidesThatFaceOutward)
{
    const Mesh mesh = read(GetParam());
    std::vector<MeshFace> sides;
    for (const auto& [group, faces] : mesh.face_groups) sides.insert(sides.end(), faces.begin(), faces.end());
    EXPECT_EQ(mesh.face_groups.size(), mesh.dimension == 2 ? 4u : 6u);
    EXPECT_NEAR(enclosed(mesh, linear_facets(mesh, sides)), exact_content(mesh.dimension), 1e-8);
}

TEST_P(MedMesh, HasGroupsByName)
{
    const Mesh mesh = read(GetParam());
    EXPECT_EQ(static_cast<int>(mesh.group_nodes("body").size()), mesh.nodes());
    std::set<int> bottom;
    for (const MeshFace& face : mesh.faces("bottom"))
        for (const int node : mesh.face_nodes(face)) bottom.insert(node);
    EXPECT_EQ(mesh.group_nodes("bottom"), std::vector<int>(bottom.begin(), bottom.end()));
    const bool quadratic = with_shape(mesh.type, [](auto shape) { return !shape.linear; });
    EXPECT_EQ(mesh.dimension == 2 ? static_cast<int>(bottom.size()) : 0, mesh.dimension == 2 ? (quadratic ? 5 : 3) : 0);
    if (mesh.dimension == 2) {
        EXPECT_EQ(mesh.group_nodes("corner"), std::vector<int>{mesh.nearest_node({1.1, 0.8})});
    }
}

INSTANTIATE_TEST_SUITE_P(EveryType, MedMesh,
                         testing::Values(ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8,
                                         ElementType::quad9, ElementType::tet4, ElementType::tet10, ElementType::hexa8,
                                         ElementType::hexa20, ElementType::hexa27),
                         [](const auto& info) { return name_of(info.param); });

TEST(MedScale, IsTheLengthOfTheFilesUnit)
{
    const std::string file = std::string(RIVAGE_TEST_DATA) + "/quad4.med";
    const Mesh metres = read_med_mesh({file, "quad4", 2}), millimetres = read_med_mesh({file, "", 2, 1e-3});
    ASSERT_EQ(metres.nodes(), millimetres.nodes());
    for (int i = 0; i < metres.nodes(); ++i) EXPECT_DOUBLE_EQ(millimetres.node(i)[0], 1e-3 * metres.node(i)[0]);
}

} // namespace

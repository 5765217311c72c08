// SPDX-License-Identifier: MIT
#include "fem_solver/output/xdmf_order.hpp"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace fem;
using Corners = std::vector<int>;

/// The corners that each node beyond the first eight lies in the middle of, as the header of VTK's
/// vtkTriQuadraticHexahedron lists and draws them.
const std::vector<Corners> between{{0, 1},
                                   {1, 2},
                                   {2, 3},
                                   {3, 0},
                                   {4, 5},
                                   {5, 6},
                                   {6, 7},
                                   {7, 4},
                                   {0, 4},
                                   {1, 5},
                                   {2, 6},
                                   {3, 7},
                                   {0, 3, 4, 7},
                                   {1, 2, 5, 6},
                                   {0, 1, 4, 5},
                                   {2, 3, 6, 7},
                                   {0, 1, 2, 3},
                                   {4, 5, 6, 7},
                                   {0, 1, 2, 3, 4, 5, 6, 7}};

template<class Shape> void expect_order_of_vtk(ElementType type)
{
    std::set<std::size_t> places;
    for (std::size_t a = 0; a < Shape::nodes; ++a) {
        const std::size_t place = own_place(type, a);
        places.insert(place);
        const Corners corners = a < 8 ? Corners{static_cast<int>(a)} : between[a - 8];
        for (std::size_t k = 0; k < 3; ++k) {
            int sum = 0;
            for (const int corner : corners) sum += Shape::corners[static_cast<std::size_t>(corner)][k];
            EXPECT_EQ(Shape::corners[place][k] * std::ssize(corners), sum) << name_of(type) << ", VTK's node " << a;
        }
    }
    EXPECT_EQ(places.size(), static_cast<std::size_t>(Shape::nodes));
}

TEST(XdmfOrder, IsThatOfVtk)
{
    expect_order_of_vtk<Hexa8>(ElementType::hexa8);
    expect_order_of_vtk<Hexa20>(ElementType::hexa20);
    expect_order_of_vtk<Hexa27>(ElementType::hexa27);
}

} // namespace

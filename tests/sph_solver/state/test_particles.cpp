// SPDX-License-Identifier: MIT
#include "sph_solver/state/canonical_order.hpp"
#include "sph_solver/state/particles.hpp"

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace sph {
namespace {

template<int D> void expect_complete_table()
{
    Particles<D> particles;
    particles.resize(5);
    std::set<std::string> names;
    std::set<const void*> columns;
    for_each_field(particles, [&](const FieldInfo& info, auto& column) {
        EXPECT_EQ(column.size(), 5U) << info.name;
        EXPECT_FALSE(info.symbol.empty()) << info.name;
        EXPECT_FALSE(info.unit_in(D).empty()) << info.name;
        EXPECT_FALSE(info.description.empty()) << info.name;
        names.insert(std::string(info.name));
        columns.insert(&column);
    });
    EXPECT_EQ(names.size(), std::tuple_size_v<decltype(field_table<D>())>);
    EXPECT_EQ(columns.size(), names.size()) << "two entries name the same column";
}

TEST(FieldTable, DescribesAndAllocatesEveryColumnOnce)
{
    expect_complete_table<2>();
    expect_complete_table<3>();
}

TEST(FieldTable, UnitsDependOnTheDimension)
{
    for_each_field(Particles<2>{}, [](const FieldInfo& info, const auto&) {
        if (info.name == "mass") {
            EXPECT_EQ(info.unit_in(2), "kg/m");
            EXPECT_EQ(info.unit_in(3), "kg");
        }
    });
}

TEST(CellGrid, KeyKeepsTheCellAndOrdersRowsAlongX)
{
    const CellGrid<3> grid(0.5);
    const CellGrid<3>::Cell cell = grid.cell_of(Vec<3>(-0.1, 0.6, 12.4));
    EXPECT_EQ(cell, (CellGrid<3>::Cell{-1, 1, 24}));
    EXPECT_EQ(CellGrid<3>::cell(CellGrid<3>::key(cell)), cell);
    EXPECT_EQ(CellGrid<3>::key({0, 1, 24}), CellGrid<3>::key(cell) + 1);
    EXPECT_LT(CellGrid<3>::key({500, 1, 24}), CellGrid<3>::key({-500, 2, 24}));
}

TEST(CellGrid, SaysThatAPositionIsNotANumber)
{
    const CellGrid<2> grid(0.5);
    EXPECT_THROW((void)grid.cell_of(Vec<2>(0.0, std::nan(""))), base::Error);
    EXPECT_THROW((void)grid.cell_of(Vec<2>(1e9, 0.0)), base::Error);
}

Particles<2> scattered()
{
    Particles<2> particles;
    particles.resize(4);
    particles.own_all();
    particles.id = {7, 3, 5, 1};
    particles.position = {{1.5, 0.5}, {0.5, 0.4}, {0.4, 0.5}, {0.5, 1.5}};
    particles.mass = {70, 30, 50, 10};
    particles.is_owned = {1, 0, 1, 1};
    return particles;
}

TEST(CanonicalOrder, IsByCellThenByIdAndMovesAllColumns)
{
    Particles<2> particles = scattered();
    const auto new_index = sort_canonically(particles, CellGrid<2>(1.0));
    EXPECT_EQ(particles.id, (std::vector<std::int64_t>{3, 5, 7, 1}));
    EXPECT_EQ(particles.mass, (std::vector<double>{30, 50, 70, 10}));
    EXPECT_EQ(particles.owned, (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(new_index, (std::vector<int>{2, 0, 1, 3}));
}

TEST(CanonicalOrder, DropHaloLeavesTheOwnedInOrder)
{
    Particles<2> particles = scattered();
    sort_canonically(particles, CellGrid<2>(1.0));
    drop_halo(particles);
    EXPECT_EQ(particles.id, (std::vector<std::int64_t>{5, 7, 1}));
    EXPECT_EQ(particles.owned, (std::vector<int>{0, 1, 2}));
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/neighbours/neighbour_search.hpp"
#include "sph_solver/state/canonical_order.hpp"
#include "tests/sph_solver/support/random_particles.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace sph {
namespace {

template<int D> std::vector<int> brute_force(const Particles<D>& particles, int i, double reach)
{
    std::vector<int> found;
    for (int j = 0; j < static_cast<int>(particles.size()); ++j) {
        const Vec<D> x_ij =
            particles.position[static_cast<std::size_t>(j)] - particles.position[static_cast<std::size_t>(i)];
        if (j != i && x_ij.squaredNorm() < reach * reach) found.push_back(j);
    }
    return found;
}

template<int D> void expect_brute_force(int count, double support)
{
    Particles<D> particles = testing::random_particles<D>(count);
    NeighbourSearch<D> search(support, 0.15 * support);
    sort_canonically(particles, search.grid());
    search.build(particles);
    ASSERT_EQ(search.list().rows(), particles.size());
    for (std::size_t k = 0; k < particles.owned.size(); ++k) {
        const auto row = search.list().of(k);
        EXPECT_EQ(std::vector<int>(row.begin(), row.end()), brute_force(particles, particles.owned[k], search.reach()));
    }
}

TEST(NeighbourSearch, FindsWhatBruteForceFindsInAscendingOrder)
{
    expect_brute_force<2>(1500, 0.05);
    expect_brute_force<3>(1500, 0.12);
}

TEST(NeighbourSearch, FilterTakesPairsOutOnBothSides)
{
    Particles<2> particles = testing::random_particles<2>(600);
    NeighbourSearch<2> search(0.1, 0.0);
    sort_canonically(particles, search.grid());
    const auto same_side = [](const Vec<2>& a, const Vec<2>& b) { return (a[1] > 0.2) == (b[1] > 0.2); };
    const double reach = search.reach();
    search.build(particles, {[&](const Vec<2>& x) { return std::abs(x[1] - 0.2) < reach; }, same_side});
    std::size_t pairs = 0;
    for (std::size_t k = 0; k < particles.owned.size(); ++k) {
        for (const int j : search.list().of(k)) {
            EXPECT_TRUE(same_side(particles.position[k], particles.position[static_cast<std::size_t>(j)]));
        }
        for (const int j : brute_force(particles, static_cast<int>(k), 0.1)) {
            pairs += same_side(particles.position[k], particles.position[static_cast<std::size_t>(j)]) ? 1 : 0;
        }
    }
    EXPECT_EQ(search.list().entries(), pairs);
}

TEST(NeighbourSearch, KnowsTheLargestDisplacement)
{
    Particles<2> particles = testing::random_particles<2>(50);
    NeighbourSearch<2> search(0.1, 0.01);
    sort_canonically(particles, search.grid());
    search.build(particles);
    EXPECT_EQ(search.largest_displacement(particles), 0.0);
    particles.position[17] += Vec<2>(0.003, -0.004);
    EXPECT_NEAR(search.largest_displacement(particles), 0.005, 1e-15);
}

TEST(NeighbourSearch, NoParticlesNoNeighbours)
{
    NeighbourSearch<3> search(0.1, 0.01);
    search.build(Particles<3>{});
    EXPECT_EQ(search.list().rows(), 0U);
    EXPECT_EQ(search.largest_displacement(Particles<3>{}), 0.0);
}

/// Rows whose indices lie more than 16 bits apart take several blocks, marks and all.
TEST(NeighbourList, GivesBackRowsOfAnyExtent)
{
    const std::vector<std::vector<int>> rows = {
        {}, {3}, {0, 65535}, {0, 65536}, {1, 2, 70000, 70001, 140000, 2000000000}, {}};
    NeighbourList list;
    for (const auto& row : rows) list.append(row);
    list.finish();
    ASSERT_EQ(list.rows(), rows.size());
    EXPECT_EQ(list.entries(), 11U);
    EXPECT_EQ(list.longest(), 6U);
    for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(list.of(k), rows[k]);
    std::vector<int> found(6 + selection_overhang);
    const std::vector<std::uint8_t> bits = {0b110101, 0, 0, 0, 0};
    Taken taken{found.data()};
    int first = 0;
    list.for_each_block(4, [&](const NeighbourBlock& block) {
        take_marked(taken, block, bits.data(), first, 70000);
        first += block.count;
    });
    EXPECT_EQ(std::vector<int>(found.data(), taken.end), (std::vector<int>{1, 70000, 140000, 2000000000}));
    EXPECT_EQ(taken.before, 1);
}

} // namespace
} // namespace sph

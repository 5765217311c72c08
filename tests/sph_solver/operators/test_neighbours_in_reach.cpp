// SPDX-License-Identifier: MIT
#include "tests/sph_solver/support/reached_neighbours.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace sph {
namespace {

template<int D> void expect_the_plain_selection(int side)
{
    constexpr double dx = 0.1, support = 2.46 * dx;
    auto particles = sample::jittered_lattice<D>(side, dx, 0.2, 1000.0);
    const auto reached = sample::reached_neighbours(particles, support);
    const auto exact = sample::brute_force_neighbours(particles, support);
    ASSERT_EQ(reached.rows(), exact.rows());
    for (std::size_t k = 0; k < exact.rows(); ++k) {
        const auto row = reached.of(k), wanted = exact.of(k);
        EXPECT_TRUE(std::equal(row.begin(), row.end(), wanted.begin(), wanted.end())) << "row " << k;
    }
}

TEST(NeighboursInReach, AreThoseOfThePlainComparison)
{
    expect_the_plain_selection<2>(9);
    expect_the_plain_selection<3>(6);
}

TEST(NeighboursInReach, RowsAreFilledUpWithTheParticleItself)
{
    auto particles = sample::jittered_lattice<2>(7, 0.1, 0.2, 1000.0);
    std::erase_if(particles.owned, [](int i) { return i % 3 == 0; });
    const auto reached = sample::reached_neighbours(particles, 0.246);
    for (std::size_t k = 0; k < reached.rows(); ++k) {
        const auto packs = reached.packs_of(k);
        EXPECT_EQ(packs.size() % pack_lanes, 0U);
        for (std::size_t n = reached.of(k).size(); n < packs.size(); ++n) EXPECT_EQ(packs[n], particles.owned[k]);
    }
}

TEST(NeighboursInReach, ALoneParticleHasNone)
{
    auto particles = sample::jittered_lattice<2>(1, 0.1, 0.0, 1000.0);
    const auto reached = sample::reached_neighbours(particles, 0.246);
    EXPECT_TRUE(reached.of(0).empty());
    EXPECT_TRUE(reached.packs_of(0).empty());
}

} // namespace
} // namespace sph

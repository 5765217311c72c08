// SPDX-License-Identifier: MIT
#include "tests/sph_solver/support/reached_neighbours.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace sph {
namespace {

template<int D> void expect_the_plain_selection(int side)
{
    constexpr double spacing = 0.1, support = 2.46 * spacing;
    auto particles = sample::jittered_lattice<D>(side, spacing, 0.2, 1000.0);
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
        const ReachedRow row = reached.row(k, particles.owned[k]);
        EXPECT_EQ(row.packs().size() % pack_lanes, 0U);
        for (std::size_t n = row.size; n < row.size + row_overhang; ++n) EXPECT_EQ(row.begin[n], particles.owned[k]);
    }
}

TEST(NeighboursInReach, AreCountedAndPartedAtTheParticleItself)
{
    const auto particles = sample::jittered_lattice<3>(5, 0.1, 0.2, 1000.0);
    const auto reached = sample::reached_neighbours(particles, 0.246);
    std::vector<int> behind(reached.longest() + row_overhang);
    for (std::size_t k = 0; k < reached.rows(); ++k) {
        const int i = particles.owned[k];
        const ReachedRow row = reached.row(k, i);
        EXPECT_EQ(row.size, reached.count(k));
        for (const int j : row.ahead()) EXPECT_LT(j, i);
        for (const int j : row.behind()) EXPECT_GT(j, i);
        const auto unfolded = std::span(behind).first(reached.unfold_behind(k, i, behind.data()));
        EXPECT_TRUE(std::equal(unfolded.begin(), unfolded.end(), row.behind().begin(), row.behind().end())) << k;
    }
}

TEST(NeighboursInReach, ALoneParticleHasNone)
{
    auto particles = sample::jittered_lattice<2>(1, 0.1, 0.0, 1000.0);
    const auto reached = sample::reached_neighbours(particles, 0.246);
    EXPECT_TRUE(reached.of(0).empty());
    EXPECT_TRUE(reached.row(0, 0).packs().empty());
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
// Who owns what, when the work is uneven, moves, or is too little for all ranks.
#include "tests/sph_solver/parallel/rank_share.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace sph {
namespace {

TEST(Rebalance, RanksShareTheWork)
{
    Particles<2> particles = share(testing::random_particles<2>(4000));
    Domain<2> domain(world(), CellGrid<2>(0.02));
    domain.redistribute(particles);
    const auto mine = static_cast<std::int64_t>(particles.owned.size());
    EXPECT_LE(world().max(mine), 4000 / world().size() * 1.1 + 1);
}

TEST(Rebalance, WaterThatRunsAwayIsCutAnew)
{
    Particles<2> particles = share(testing::random_particles<2>(2000));
    NeighbourSearch<2> search(0.04, 0.0);
    Domain<2> domain(world(), search.grid(), {.limit = 1.1, .rebuilds_between = 3});
    for (int round = 0; round < 12; ++round) {
        domain.redistribute(particles);
        search.build(particles);
        record_neighbours(domain, particles, search.list());
        for (Vec<2>& x : particles.position) x *= round < 6 ? 0.9 : 1.0; // drains towards one corner
    }
    if (world().size() > 1) {
        EXPECT_GT(domain.balance().cuts(), 1);
    }
    const auto mine = static_cast<std::int64_t>(search.list().entries());
    EXPECT_LE(static_cast<double>(world().max(mine)), 1.35 * static_cast<double>(world().sum(mine)) / world().size());
}

/// Particles on a line, one a block, with the same cost each but for the first quarter, which costs `factor` times more.
struct Line {
    static constexpr int count = 240;

    Line() : domain(world(), CellGrid<2>(0.1), {.limit = 1.1, .rebuilds_between = 2})
    {
        particles.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            particles.id[i] = static_cast<std::int64_t>(i);
            particles.position[i] = {0.1 * (static_cast<double>(i) + 0.5), 0.05};
        }
        particles.own_all();
        particles = share(particles);
        domain.redistribute(particles);
    }

    /// \return this rank's cost
    double rebuild(double factor)
    {
        std::vector<double> costs;
        for (const int owned : particles.owned)
            costs.push_back(particles.id[static_cast<std::size_t>(owned)] < count / 4 ? 1e-6 * factor : 1e-6);
        const double mine = std::accumulate(costs.begin(), costs.end(), 0.0);
        domain.record_work(particles, costs, mine);
        domain.redistribute(particles);
        return mine;
    }

    double imbalance(double mine) const { return world().max(mine) * world().size() / world().sum(mine); }

    Domain<2> domain;
    Particles<2> particles;
};

TEST(Rebalance, IsCutByTheMeasuredCostOfTheParticles)
{
    Line line;
    for (int round = 0; round < 8; ++round) line.rebuild(9.0);
    EXPECT_LE(line.imbalance(line.rebuild(9.0)), 1.1);
}

TEST(Rebalance, ACutThatPromisesNothingIsDeclined)
{
    Line line;
    for (int round = 0; round < 12; ++round) { // a rank that is slow in itself: no cut can help
        std::vector<double> costs(line.particles.owned.size(), 1e-6);
        line.domain.record_work(line.particles, costs, world().is_root() ? 2.0 : 1.0);
        line.domain.redistribute(line.particles);
    }
    if (world().size() == 1) return;
    EXPECT_EQ(line.domain.balance().cuts(), 1);
    EXPECT_GT(line.domain.balance().declined(), 1);
    EXPECT_NEAR(line.domain.balance().present(), 2.0 * world().size() / (world().size() + 1.0), 1e-12);
}

TEST(Rebalance, ANewCutLeavesMostParticlesWhereTheyAre)
{
    Line line;
    for (int round = 0; round < 8; ++round) line.rebuild(1.0);
    std::vector<std::int64_t> before;
    for (const int owned : line.particles.owned) before.push_back(line.particles.id[static_cast<std::size_t>(owned)]);
    for (int round = 0; round < 8; ++round) line.rebuild(2.0);
    std::int64_t stayed = 0;
    for (const int owned : line.particles.owned)
        stayed += std::binary_search(before.begin(), before.end(), line.particles.id[static_cast<std::size_t>(owned)]);
    EXPECT_GE(world().sum(stayed), Line::count / 2);
    EXPECT_EQ(line.domain.balance().cuts() > 1, world().size() > 1);
}

/// All water flows into the blocks of one rank, which leaves the others without; a later cut gives them some again.
TEST(Rebalance, ARankThatHasRunEmptyGetsParticlesAgain)
{
    Particles<2> particles = share(testing::random_particles<2>(1000));
    NeighbourSearch<2> search(0.05, 0.0);
    Domain<2> domain(world(), search.grid(), {.limit = 1.1, .rebuilds_between = 4});
    domain.redistribute(particles);
    const auto box = [](const Vec<2>& x) { return Vec<2>(0.049 * x[0] + 0.0005, 0.049 * x[1] + 0.0005); };
    for (Vec<2>& x : particles.position) x = box(x.cwiseAbs().cwiseMin(1.0)); // into one block
    std::int64_t fewest = 1;
    for (int round = 0; round < 12; ++round) {
        domain.redistribute(particles);
        search.build(particles);
        record_neighbours(domain, particles, search.list());
        fewest = std::min(fewest, -world().max(-static_cast<std::int64_t>(particles.owned.size())));
        if (round == 3)
            for (Vec<2>& x : particles.position) x = (x * 30.0).eval(); // and out again
    }
    EXPECT_EQ(world().sum(static_cast<std::int64_t>(particles.owned.size())), 1000);
    EXPECT_EQ(fewest == 0, world().size() > 1);
    EXPECT_GT(particles.owned.size(), 0U);
}

} // namespace
} // namespace sph

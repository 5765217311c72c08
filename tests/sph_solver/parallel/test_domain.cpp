// SPDX-License-Identifier: MIT
// The same random particles on all ranks, each takes a share; what the ranks then find together must be what one rank
// finds alone, to the last bit.
#include "sph_solver/neighbours/neighbour_search.hpp"
#include "sph_solver/parallel/domain.hpp"
#include "tests/sph_solver/support/random_particles.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace sph {
namespace {

const base::Communicator& world()
{
    static const base::Communicator comm = base::Communicator::world();
    return comm;
}

/// Every `size`-th particle: an initial distribution that has nothing to do with space.
template<int D> Particles<D> share(Particles<D> all)
{
    std::vector<std::uint8_t> mine(all.size(), 0);
    for (std::size_t i = 0; i < all.size(); ++i)
        mine[i] = static_cast<int>(i) % world().size() == world().rank() ? 1 : 0;
    keep_particles(all, mine);
    return all;
}

/// As if a particle cost a nanosecond for each neighbour.
template<int D> void record_neighbours(Domain<D>& domain, const Particles<D>& particles, const NeighbourList& list)
{
    std::vector<double> costs;
    for (std::size_t k = 0; k < list.rows(); ++k) costs.push_back(1e-9 * static_cast<double>(list.of(k).size()));
    domain.record_work(particles, costs, std::accumulate(costs.begin(), costs.end(), 0.0));
}

struct Sum {
    std::int64_t id;
    double value;
    std::int64_t neighbours;
};

/// A sum over neighbours whose value depends on the order of its terms; for all particles, by id, on every rank.
template<int D>
std::vector<Sum> neighbour_sums(const Particles<D>& particles, const NeighbourList& list,
                                const base::Communicator& comm)
{
    std::vector<Sum> sums;
    for (std::size_t k = 0; k < particles.owned.size(); ++k) {
        const auto i = static_cast<std::size_t>(particles.owned[k]);
        Sum sum{particles.id[i], 0.0, 0};
        for (const int neighbour : list.of(k)) {
            const auto j = static_cast<std::size_t>(neighbour);
            const double r = (particles.position[j] - particles.position[i]).norm();
            sum.value +=
                particles.mass[j] / particles.volume[j] * (1.0 - r) + particles.momentum[j].dot(particles.position[j]);
            ++sum.neighbours;
        }
        sums.push_back(sum);
    }
    sums = comm.gather_all(sums);
    std::sort(sums.begin(), sums.end(), [](const Sum& a, const Sum& b) { return a.id < b.id; });
    return sums;
}

void expect_same(const std::vector<Sum>& found, const std::vector<Sum>& wanted)
{
    EXPECT_EQ(found.size(), wanted.size());
    std::size_t differing = 0;
    for (std::size_t i = 0; i < std::min(found.size(), wanted.size()); ++i) {
        const bool same = found[i].id == wanted[i].id && found[i].value == wanted[i].value &&
                          found[i].neighbours == wanted[i].neighbours;
        differing += same ? 0 : 1;
    }
    EXPECT_EQ(differing, 0U);
}

/// Moves the particles by a shear that depends on the position alone: the same on any rank.
template<int D> void move(Particles<D>& particles, double amount)
{
    for (const int owned : particles.owned) {
        Vec<D>& x = particles.position[static_cast<std::size_t>(owned)];
        x[0] += amount * (1.0 + x[1]);
    }
}

template<int D> void expect_rank_invariance(int count, double support)
{
    NeighbourSearch<D> search(support, 0.1 * support);
    NeighbourSearch<D> reference_search(support, 0.1 * support);
    Domain<D> domain(world(), search.grid(), {.limit = 1.05, .rebuilds_between = 2});
    Domain<D> alone(base::Communicator::self(), search.grid());
    Particles<D> reference = testing::random_particles<D>(count);
    Particles<D> particles = share(reference);
    for (int round = 0; round < 6; ++round) {
        domain.redistribute(particles);
        search.build(particles);
        record_neighbours(domain, particles, search.list());
        alone.redistribute(reference);
        reference_search.build(reference);
        expect_same(neighbour_sums(particles, search.list(), world()),
                    neighbour_sums(reference, reference_search.list(), base::Communicator::self()));
        move(particles, 0.11);
        move(reference, 0.11);
    }
}

TEST(Domain, NeighbourSumsAreTheSameToTheLastBitOnAnyNumberOfRanks2D) { expect_rank_invariance<2>(1200, 0.04); }

TEST(Domain, NeighbourSumsAreTheSameToTheLastBitOnAnyNumberOfRanks3D) { expect_rank_invariance<3>(1200, 0.1); }

TEST(Domain, MigrationKeepsEveryParticleExactlyOnceWithAllItsFields)
{
    const Particles<2> all = testing::random_particles<2>(500);
    Particles<2> particles = share(all);
    Domain<2> domain(world(), CellGrid<2>(0.05));
    for (int round = 0; round < 3; ++round) {
        domain.redistribute(particles);
        std::vector<std::int64_t> ids;
        for (const int owned : particles.owned) {
            const auto i = static_cast<std::size_t>(owned);
            const auto g = static_cast<std::size_t>(particles.id[i]);
            ids.push_back(particles.id[i]);
            EXPECT_EQ(particles.mass[i], all.mass[g]);
            EXPECT_EQ(particles.momentum[i], all.momentum[g]);
            EXPECT_NEAR(particles.position[i][0], all.position[g][0] + 0.3 * round, 1e-12);
            EXPECT_EQ(particles.position[i][1], all.position[g][1]);
        }
        ids = world().gather_all(ids);
        std::sort(ids.begin(), ids.end());
        EXPECT_EQ(ids, all.id);
        for (Vec<2>& x : particles.position) x[0] += 0.3;
    }
}

TEST(Domain, RefreshBringsTheOwnersValuesToEveryCopy)
{
    Particles<2> particles = share(testing::random_particles<2>(800));
    Domain<2> domain(world(), CellGrid<2>(0.08));
    domain.redistribute(particles);
    const auto from_id = [](std::int64_t id) { return 3.0 * static_cast<double>(id) + 1.0; };
    for (const int owned : particles.owned) {
        const auto i = static_cast<std::size_t>(owned);
        particles.mass[i] = from_id(particles.id[i]);
        particles.velocity_gradient[i].setConstant(from_id(particles.id[i]));
    }
    domain.start_state(particles);
    domain.finish_state(particles);
    domain.start_gradients(particles);
    domain.finish_gradients(particles);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        EXPECT_EQ(particles.mass[i], from_id(particles.id[i]));
        EXPECT_EQ(particles.velocity_gradient[i](1, 0), from_id(particles.id[i]));
    }
    const auto copies = static_cast<std::int64_t>(particles.size() - particles.owned.size());
    EXPECT_EQ(world().sum(copies) > 0, world().size() > 1);
}

TEST(Domain, RanksShareTheWork)
{
    Particles<2> particles = share(testing::random_particles<2>(4000));
    Domain<2> domain(world(), CellGrid<2>(0.02));
    domain.redistribute(particles);
    const auto mine = static_cast<std::int64_t>(particles.owned.size());
    EXPECT_LE(world().max(mine), 4000 / world().size() * 1.1 + 1);
}

TEST(Domain, FewerBlocksThanRanksLeaveRanksEmpty)
{
    Particles<2> all = testing::random_particles<2>(2);
    Particles<2> particles = share(all);
    NeighbourSearch<2> search(0.1, 0.0);
    Domain<2> domain(world(), search.grid());
    domain.redistribute(particles);
    search.build(particles);
    EXPECT_EQ(search.list().indices.size(), 0U);
    EXPECT_EQ(world().sum(static_cast<std::int64_t>(particles.owned.size())), 2);
    domain.start_state(particles);
    domain.finish_state(particles);
}

TEST(Domain, WaterThatRunsAwayIsCutAnew)
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
    const auto mine = static_cast<std::int64_t>(search.list().indices.size());
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

TEST(Domain, IsCutByTheMeasuredCostOfTheParticles)
{
    Line line;
    for (int round = 0; round < 8; ++round) line.rebuild(9.0);
    EXPECT_LE(line.imbalance(line.rebuild(9.0)), 1.1);
}

TEST(Domain, ACutThatPromisesNothingIsDeclined)
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

TEST(Domain, ANewCutLeavesMostParticlesWhereTheyAre)
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
TEST(Domain, ARankThatHasRunEmptyGetsParticlesAgain)
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

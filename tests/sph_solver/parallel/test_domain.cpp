// SPDX-License-Identifier: MIT
// The same random particles on all ranks, each takes a share; what the ranks then find together must be what one rank
// finds alone, to the last bit.
#include "sph_solver/neighbours/row_set.hpp"
#include "tests/sph_solver/parallel/rank_share.hpp"
#include "tests/sph_solver/support/sample_fluid.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace sph {
namespace {

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

/// The neighbours of each particle, by id in ascending order, on all ranks together.
template<int D>
std::vector<std::pair<std::int64_t, std::int64_t>> pairs_by_id(const Particles<D>& particles, const NeighbourList& list)
{
    std::vector<std::pair<std::int64_t, std::int64_t>> pairs;
    for (std::size_t k = 0; k < list.rows(); ++k)
        for (const int j : list.of(k))
            pairs.emplace_back(particles.id[static_cast<std::size_t>(particles.owned[k])],
                               particles.id[static_cast<std::size_t>(j)]);
    return pairs;
}

template<int D> void expect_brute_force(int count, double support)
{
    const Particles<D> all = testing::random_particles<D>(count);
    Particles<D> particles = share(all);
    NeighbourSearch<D> search(support, 0.2 * support);
    Domain<D> domain(world(), search.grid());
    domain.redistribute(particles);
    search.build(particles);
    struct Pair {
        std::int64_t i, j;
    };
    std::vector<Pair> mine;
    for (const auto& [i, j] : pairs_by_id(particles, search.list())) mine.push_back({i, j});
    std::vector<std::pair<std::int64_t, std::int64_t>> found;
    for (const Pair& pair : world().gather_all(mine)) found.emplace_back(pair.i, pair.j);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, pairs_by_id(all, sample::brute_force_neighbours(all, search.reach())));
}

TEST(Domain, NeighboursOnAllRanksAreThoseOfBruteForce)
{
    expect_brute_force<2>(700, 0.06);
    expect_brute_force<3>(700, 0.15);
}

/// The halo is what lies within reach of a block of mine, and no more.
TEST(Domain, HaloIsThatOfBruteForce)
{
    const Particles<2> all = testing::random_particles<2>(900);
    Particles<2> particles = share(all);
    const double reach = 0.07;
    Domain<2> domain(world(), CellGrid<2>(reach));
    domain.redistribute(particles);
    std::size_t wanted = 0;
    for (const Vec<2>& x : all.position) {
        const auto cell = domain.blocks().grid().cell_of(x);
        if (domain.blocks().owner(CellGrid<2>::key(cell)) == world().rank()) continue;
        bool near = false;
        for (int n = 0; n < 9; ++n) {
            const std::array<int, 2> other = {cell[0] + n % 3 - 1, cell[1] + n / 3 - 1};
            if (domain.blocks().owner(CellGrid<2>::key(other)) != world().rank()) continue;
            const Vec<2> low(other[0] * reach, other[1] * reach);
            const Vec<2> nearest = x.cwiseMax(low).cwiseMin(Vec<2>(low.array() + reach));
            near = near || (x - nearest).norm() <= reach;
        }
        wanted += near ? 1 : 0;
    }
    EXPECT_EQ(particles.size() - particles.owned.size(), wanted);
}

TEST(Domain, RowsAreSplitByTheirNeedOfOthers)
{
    Particles<2> particles = share(testing::random_particles<2>(900));
    NeighbourSearch<2> search(0.06, 0.0);
    Domain<2> domain(world(), search.grid());
    domain.redistribute(particles);
    search.build(particles);
    RowSplit split;
    split.find(search.list(), particles.is_owned);
    EXPECT_EQ(split.inner.size() + split.border.size(), particles.owned.size());
    EXPECT_EQ(split.halo.size(), particles.size() - particles.owned.size());
    const auto needs_others = [&](int k) {
        const auto row = search.list().of(static_cast<std::size_t>(k));
        return std::any_of(row.begin(), row.end(),
                           [&](int j) { return particles.is_owned[static_cast<std::size_t>(j)] == 0; });
    };
    EXPECT_TRUE(std::none_of(split.inner.begin(), split.inner.end(), needs_others));
    EXPECT_TRUE(std::all_of(split.border.begin(), split.border.end(), needs_others));
    EXPECT_EQ(world().any(!split.border.empty()), world().size() > 1);
}

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

TEST(Domain, FewerBlocksThanRanksLeaveRanksEmpty)
{
    Particles<2> all = testing::random_particles<2>(2);
    Particles<2> particles = share(all);
    NeighbourSearch<2> search(0.1, 0.0);
    Domain<2> domain(world(), search.grid());
    domain.redistribute(particles);
    search.build(particles);
    EXPECT_EQ(search.list().entries(), 0U);
    EXPECT_EQ(world().sum(static_cast<std::int64_t>(particles.owned.size())), 2);
    domain.start_state(particles);
    domain.finish_state(particles);
}

} // namespace
} // namespace sph

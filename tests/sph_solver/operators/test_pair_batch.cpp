// SPDX-License-Identifier: MIT
#include "sph_solver/operators/pair_batch.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace sph {
namespace {

/// Rows of random length over neighbours behind them, some with neighbours of their own before them.
struct RandomRows {
    RandomRows(int particles, bool own_sides)
    {
        std::mt19937 random(11);
        for (int i = 0; i < particles; ++i) {
            auto& [own, shared] = rows.emplace_back();
            for (int j = i + 1; j < particles && shared.size() < random() % 14; ++j) shared.push_back(j);
            for (int j = 0; own_sides && i % 3 == 0 && j < i && own.size() < random() % 9; ++j) own.push_back(j);
            longest = std::max(longest, own.size() + shared.size());
        }
    }

    /// Adds row i, with something readable behind each side.
    void add_to(PairBatch& batch, std::size_t i) const
    {
        auto [own, shared] = rows[i];
        own.resize(own.size() + row_unit);
        shared.resize(shared.size() + row_unit);
        batch.add(static_cast<int>(i), i, std::span(own).first(rows[i].own.size()),
                  std::span(shared).first(rows[i].shared.size()));
    }

    [[nodiscard]] std::size_t pairs() const
    {
        std::size_t count = 0;
        for (const auto& [own, shared] : rows) count += own.size() + shared.size();
        return count;
    }

    struct Sides {
        std::vector<int> own, shared;
    };
    std::vector<Sides> rows;
    std::size_t longest = 0;
};

int owner(const PairBatch& batch, std::size_t pair)
{
    const PackOwners& owners = batch.owners(pair / pack_lanes);
    return pair % pack_lanes < owners.split ? owners.first : owners.second;
}

TEST(PairBatch, HoldsEachPairOfEachRowBesideItsOwner)
{
    const RandomRows random(20, true);
    PairBatch batch(random.longest);
    for (std::size_t i = 0; i < random.rows.size(); ++i) random.add_to(batch, i);
    ASSERT_EQ(batch.rows().size(), random.rows.size());
    ASSERT_LT(batch.packs() * pack_lanes, random.pairs() + random.rows.size() * pack_lanes);
    std::vector<bool> taken(batch.packs() * pack_lanes, false);
    for (const PairBatch::Row& row : batch.rows()) {
        const auto& [own, shared] = random.rows[row.k];
        ASSERT_EQ(row.own, own.size());
        ASSERT_EQ(row.end - row.begin, own.size() + shared.size());
        for (std::size_t pair = row.begin; pair < row.end; ++pair) {
            const std::size_t n = pair - row.begin;
            EXPECT_EQ(owner(batch, pair), row.particle);
            EXPECT_EQ(batch.other(pair), n < own.size() ? own[n] : shared[n - own.size()]);
            taken[pair] = true;
        }
    }
    for (std::size_t pair = 0; pair < taken.size(); ++pair)
        EXPECT_TRUE(taken[pair] || batch.other(pair) == owner(batch, pair)) << "a free lane is a pair with itself";
}

TEST(PairBatch, SumsAreThoseOfTheRowsInTheirOrder)
{
    using Sums = PairSums<3, 2>;
    const RandomRows random(20, false);
    PairBatch batch(random.longest);
    for (std::size_t i = 0; i < random.rows.size(); ++i) random.add_to(batch, i);
    Sums sums(random.rows.size(), batch.most_packs());
    const auto of_pair = [](std::size_t n, int i, int j) { return std::sin(1.0 + 3.0 * i + 5.0 * j + double(n)); };
    for (std::size_t pack = 0; pack < batch.packs(); ++pack) {
        std::array<Pack, Sums::size> columns{};
        for (std::size_t n = 0; n < 3; ++n)
            for (std::size_t lane = 0; lane < pack_lanes; ++lane) {
                const std::size_t pair = pack * pack_lanes + lane;
                columns[n][lane] = of_pair(n, owner(batch, pair), batch.other(pair));
            }
        sums.put(pack, columns);
    }
    std::vector<std::array<double, 3>> expected(random.rows.size());
    for (std::size_t i = 0; i < random.rows.size(); ++i)
        for (const int j : random.rows[i].shared)
            for (std::size_t n = 0; n < 3; ++n) {
                const double value = of_pair(n, static_cast<int>(i), j);
                expected[i][n] += n < 2 ? -value : value;
                expected[static_cast<std::size_t>(j)][n] += value;
            }
    sums.sum(batch, [&](std::size_t k, const auto& numbers) {
        for (std::size_t n = 0; n < 3; ++n) EXPECT_NEAR(numbers[n], expected[k][n], 1e-13);
    });
}

} // namespace
} // namespace sph

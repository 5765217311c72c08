// SPDX-License-Identifier: MIT
#include "sph_solver/neighbours/close_points.hpp"
#include "tests/sph_solver/support/random_particles.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace sph {
namespace {

/// Both selections against a plain loop, for ranges and lists of every length from 0 to 40: whole packs and what is left.
template<int D> void expect_plain_loop()
{
    const Particles<D> particles = testing::random_particles<D>(40);
    const std::vector<Vec<D>>& x = particles.position;
    const double limit = 0.3;
    PointColumns<D> columns;
    PointRows<D> rows;
    columns.load(x);
    rows.load(x);
    std::vector<int> found(x.size() + selection_overhang);
    std::vector<std::uint8_t> bits(x.size() / 8 + 4);
    for (int i = 0; i < 40; ++i) {
        for (int begin = 0; begin <= 40; begin += 3) {
            for (int end = begin; end <= 40; ++end) {
                std::vector<int> wanted, listed;
                for (int j = begin; j < end; ++j) {
                    if (j == i) continue;
                    listed.push_back(j);
                    const Vec<D> x_ij = x[static_cast<std::size_t>(j)] - x[static_cast<std::size_t>(i)];
                    if (x_ij.squaredNorm() < limit) wanted.push_back(j);
                }
                ASSERT_EQ(std::vector<int>(found.data(), columns.select(i, limit, begin, end, found.data())), wanted);
                NeighbourList list;
                list.append(listed);
                list.finish();
                listed.resize(listed.size() + row_unit, i);
                rows.mark(i, limit, std::span(listed).first(listed.size() - row_unit), bits.data());
                Taken all{found.data()}, behind{found.data()};
                list.for_each_block(0,
                                    [&](const NeighbourBlock& block) { take_marked(all, block, bits.data(), 0, i); });
                ASSERT_EQ(std::vector<int>(found.data(), all.end), wanted);
                const auto first_behind = std::upper_bound(wanted.begin(), wanted.end(), i);
                ASSERT_EQ(all.before, first_behind - wanted.begin());
                list.for_each_block(
                    0, [&](const NeighbourBlock& block) { take_marked<true>(behind, block, bits.data(), 0, i); });
                ASSERT_EQ(std::vector<int>(found.data(), behind.end), std::vector<int>(first_behind, wanted.end()));
            }
        }
    }
}

TEST(ClosePoints, AreThoseOfAPlainLoop)
{
    expect_plain_loop<2>();
    expect_plain_loop<3>();
}

} // namespace
} // namespace sph

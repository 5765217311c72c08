// SPDX-License-Identifier: MIT
#include "sph_solver/parallel/partition.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace sph {
namespace {

/// A chain of blocks with the given work.
WeightedGraph chain(const std::vector<std::int64_t>& work)
{
    WeightedGraph graph;
    graph.vertex_weights = work;
    const auto count = static_cast<std::int64_t>(work.size());
    for (std::int64_t v = 0; v < count; ++v) {
        for (const std::int64_t u : {v - 1, v + 1}) {
            if (u < 0 || u >= count) continue;
            graph.adjacency.push_back(u);
            graph.edge_weights.push_back(1);
        }
        graph.offsets.push_back(static_cast<std::int64_t>(graph.adjacency.size()));
    }
    return graph;
}

TEST(Partition, SharesTheWorkNotTheBlocks)
{
    std::vector<std::int64_t> work(60, 10);
    std::fill(work.begin(), work.begin() + 20, 40); // 800 + 400
    const auto parts = partition(chain(work), 3);
    std::vector<std::int64_t> sums(3, 0);
    for (std::size_t v = 0; v < work.size(); ++v) sums[static_cast<std::size_t>(parts[v])] += work[v];
    for (const std::int64_t sum : sums) EXPECT_NEAR(static_cast<double>(sum), 400.0, 80.0);
}

TEST(Partition, SameGraphSameAnswer)
{
    const auto graph = chain(std::vector<std::int64_t>(101, 3'000'000'000));
    EXPECT_EQ(partition(graph, 4), partition(graph, 4));
}

TEST(Partition, FewerBlocksThanParts)
{
    EXPECT_EQ(partition(chain({5, 5}), 4), (std::vector<int>{0, 1}));
    EXPECT_TRUE(partition(WeightedGraph{}, 3).empty());
}

TEST(Partition, KeepsTheOwnersOfMostWork)
{
    const std::vector<std::int64_t> work = {5, 5, 1, 5, 5, 1};
    EXPECT_EQ(keep_owners({0, 0, 1, 1, 1, 2}, {2, 2, 2, 0, 0, 1}, work, 3), (std::vector<int>{2, 2, 0, 0, 0, 1}));
    EXPECT_EQ(keep_owners({0, 1, 2}, {-1, -1, 0}, {1, 1, 1}, 3),
              (std::vector<int>{1, 2, 0}));                                      // new blocks take what is left
    EXPECT_EQ(keep_owners({1, 1}, {0, 1}, {3, 4}, 4), (std::vector<int>{1, 1})); // more ranks than blocks
}

TEST(Partition, ImbalanceIsTheLargestOverTheMean)
{
    EXPECT_DOUBLE_EQ(imbalance({0, 1, 1}, {2, 2, 2}, 2), 4.0 / 3.0);
    EXPECT_DOUBLE_EQ(imbalance({0, 0}, {2, 2}, 4), 4.0);
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/communicator.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Communicator, ReducesOverAllRanks)
{
    const auto world = base::Communicator::world();
    const double me = world.rank();
    EXPECT_EQ(world.sum(1.0), world.size());
    EXPECT_EQ(world.sum(std::int64_t{1} << 40), static_cast<std::int64_t>(world.size()) << 40);
    EXPECT_EQ(world.min(me), 0.0);
    EXPECT_EQ(world.max(me), world.size() - 1.0);
    EXPECT_TRUE(world.any(world.rank() == world.size() - 1));
    EXPECT_FALSE(world.any(false));
}

TEST(Communicator, GathersInRankOrderAlsoFromEmptyRanks)
{
    const auto world = base::Communicator::world();
    const std::vector<int> mine(static_cast<std::size_t>(world.rank()), world.rank());
    std::vector<int> expected;
    for (int rank = 0; rank < world.size(); ++rank) expected.insert(expected.end(), static_cast<std::size_t>(rank), rank);
    EXPECT_EQ(world.gather_all(mine), expected);
}

TEST(Communicator, BroadcastsTextOfAnyLength)
{
    const auto world = base::Communicator::world();
    const std::string text = "coupling \xc3\xa9nergie";
    EXPECT_EQ(world.broadcast(world.is_root() ? text : "other"), text);
    EXPECT_EQ(world.broadcast(world.is_root() ? "" : "other"), "");
}

}  // namespace

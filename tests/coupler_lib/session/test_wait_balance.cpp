// SPDX-License-Identifier: MIT
// What is said about the waits at the end of a run.
#include "coupler_lib/session/wait_balance.hpp"

#include <gtest/gtest.h>

namespace {

using coupler::wait_advice;

TEST(WaitBalance, TakesRanksFromTheSideThatWaits)
{
    EXPECT_EQ(wait_advice({{"fluid", 2, 0.03}, {"solid", 2, 0.62}}),
              "fluid waits 3 %, solid waits 62 %: give solid fewer ranks, or fluid more");
}

TEST(WaitBalance, CannotTakeTheLastRank)
{
    EXPECT_EQ(wait_advice({{"fluid", 1, 0.4}, {"solid", 1, 0.0}}),
              "fluid waits 40 %, solid waits 0 %: give solid more ranks");
}

TEST(WaitBalance, NamesAllOtherSides)
{
    EXPECT_EQ(wait_advice({{"fluid", 1, 0.0}, {"gate", 1, 0.5}, {"plate", 1, 0.2}}),
              "fluid waits 0 %, gate waits 50 %, plate waits 20 %: give fluid more ranks");
}

TEST(WaitBalance, LeavesAFairShareAlone)
{
    EXPECT_EQ(wait_advice({{"fluid", 4, 0.05}, {"solid", 1, 0.12}}), "fluid waits 5 %, solid waits 12 %: balanced");
    EXPECT_EQ(wait_advice({}), "");
    EXPECT_EQ(wait_advice({{"fluid", 1, 0.45}}), "fluid waits 45 %");
}

TEST(WaitBalance, SurvivesTheMessage)
{
    const auto got = coupler::wait_share_from("solid", coupler::to_text({"solid", 3, 0.1}));
    EXPECT_EQ(got.ranks, 3);
    EXPECT_EQ(got.share, 0.1);
}

} // namespace

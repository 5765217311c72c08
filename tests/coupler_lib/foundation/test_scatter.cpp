// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/scatter.hpp"

#include <array>
#include <gtest/gtest.h>

namespace {

/// Every rank owns items 0 and 1 and holds copies of item 1 of both its neighbours on a ring, interleaved.
TEST(Scatter, BringsTheOwnersValuesToTheHalo)
{
    const auto world = base::Communicator::world();
    if (world.size() == 1) return;
    const int previous = (world.rank() + world.size() - 1) % world.size();
    const int next = (world.rank() + 1) % world.size();
    base::ScatterPlan plan;
    plan.neighbours = previous == next ? std::vector<int>{next} : std::vector<int>{previous, next};
    for (std::size_t k = 0; k < plan.neighbours.size(); ++k) {
        plan.send_indices.push_back(3);
        plan.send_offsets.push_back(static_cast<int>(k) + 1);
        plan.receive_indices.push_back(k == 0 ? 1 : 2);
        plan.receive_offsets.push_back(static_cast<int>(k) + 1);
    }
    const base::Scatter scatter(world, plan);
    const double mine = world.rank();
    std::vector<double> density{mine, -1, -1, 10 + mine};
    std::vector<std::array<double, 2>> velocity{{mine, 0}, {-1, -1}, {-1, -1}, {mine, 5}};
    scatter.forward(density, velocity);
    EXPECT_EQ(density[1], 10 + plan.neighbours[0]);
    EXPECT_EQ(velocity[1][0], plan.neighbours[0]);
    EXPECT_EQ(velocity[1][1], 5);
    if (plan.neighbours.size() == 2) {
        EXPECT_EQ(density[2], 10 + plan.neighbours[1]);
    }
    EXPECT_EQ(density[0], mine);
    EXPECT_EQ(density[3], 10 + mine);

    scatter.start(density); // what was sent is sent, whatever happens to it before the end
    density[3] = -7;
    density[1] = -7;
    scatter.finish(density);
    EXPECT_EQ(density[1], 10 + plan.neighbours[0]);
    EXPECT_EQ(density[3], -7);
}

}  // namespace

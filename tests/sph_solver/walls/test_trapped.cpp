// SPDX-License-Identifier: MIT
#include "sph_solver/walls/trapped.hpp"

#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;

/// A floor at y = 0, its solid below, and a ceiling at `height`, its solid above; particles 0.2 above the floor.
std::vector<std::uint8_t> trapped_below(double height, double gap, const std::vector<Vec<2>>& positions)
{
    Walls<2> walls = lines({{{8, 0}, {-8, 0}}, {{-4, height}, {4, height}}});
    const auto particles = particles_at<2>(positions);
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);
    return find_trapped(walls.contacts(), gap, particles.owned.size());
}

TEST(Trapped, IsWhatStandsBetweenWallsThatFaceEachOther)
{
    const std::vector<Vec<2>> positions = {Vec<2>(0, 0.2), Vec<2>(7, 0.2)}; // under the ceiling, and far from it
    EXPECT_EQ(trapped_below(0.45, 0.5, positions), (std::vector<std::uint8_t>{1, 0}));
    EXPECT_EQ(trapped_below(0.55, 0.5, positions), (std::vector<std::uint8_t>{0, 0}));
    EXPECT_TRUE(trapped_below(0.1, 0.0, positions).empty());
}

TEST(Trapped, ACornerTrapsNothing)
{
    Walls<2> walls = lines({{{8, 0}, {0, 0}, {0, 8}}});
    const auto particles = particles_at<2>({Vec<2>(0.1, 0.1)});
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);
    ASSERT_EQ(walls.contacts().planes.size(), 2u);
    EXPECT_EQ(find_trapped(walls.contacts(), 0.5, 1), (std::vector<std::uint8_t>{0}));
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
// What a particle sees of the walls must not depend on when its rank has prepared them.
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;

/// A floor from x = 4 to 0 that stands still, and a piece of the interface that goes on with it to x = -4, `gap` higher.
void set_floor(Walls<2>& walls, double gap)
{
    VertexMotion<2> motion;
    motion.position = {Vec<2>(0, gap), Vec<2>(-4, gap)};
    motion.velocity = {Vec<2>::Zero(), Vec<2>::Zero()};
    motion.acceleration = motion.velocity;
    WallFacet<2> facet;
    facet.vertex = {0, 1};
    facet.corner = {0, 1};
    walls.set_moving({"plate"}, motion, {facet});
    walls.move(0);
}

std::size_t planes(Walls<2>& walls, const Particles<2>& particles)
{
    walls.find_contacts(particles);
    return walls.contacts().planes.size();
}

TEST(Walls, TouchingIsRenewedWithoutPreparingAnew)
{
    const auto particles = particles_at<2>({Vec<2>(0.3, 1.0)});
    Walls<2> walls = lines({{{4, 0}, {0, 0}}});
    set_floor(walls, 0.3);
    walls.prepare(particles, 0.5);
    EXPECT_EQ(planes(walls, particles), 2u); // two sheets
    set_floor(walls, 0);
    ASSERT_FALSE(walls.stale());
    walls.renew_touching();
    EXPECT_EQ(planes(walls, particles), 1u); // one sheet, as for a rank that prepares now
    walls.prepare(particles, 0.5);
    EXPECT_EQ(planes(walls, particles), 1u);
}

TEST(Walls, TouchingOfADrivenWallIsRenewedToo)
{
    const auto particles = particles_at<2>({Vec<2>(0.3, 1.0)});
    Walls<2> walls = lines({{{4, 0}, {0, 0}}});
    RigidMotion<2> down;
    down.translation[1] = base::with_derivatives([](double t) { return -0.1 * t; }, 1e-3);
    walls.add_driven({"lid"}, {0, 0.3, -4, 0.3}, {{0, 1, -1, -1}}, down);
    walls.start_step(0);
    walls.move(0);
    walls.prepare(particles, 0.5);
    EXPECT_EQ(planes(walls, particles), 2u); // two sheets
    walls.start_step(3);
    walls.move(0);
    walls.renew_touching();
    EXPECT_EQ(planes(walls, particles), 1u);
}

} // namespace
} // namespace sph

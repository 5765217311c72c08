// SPDX-License-Identifier: MIT
#include "tests/sph_solver/interface/wet_plate.hpp"

namespace sph {
namespace {

using namespace sample;

TEST(InterfaceGeometry, RegionHoldsParticlesAndSeldomChanges)
{
    auto particles = jittered_lattice<2>(4, 1.0, 0.0, 1000);
    const auto region = region_of(particles, 2.5, 4.0);
    EXPECT_DOUBLE_EQ(region.low[0], -4);
    EXPECT_DOUBLE_EQ(region.high[0], 8);
    for (auto& x : particles.position) x.x() += 0.2;
    const auto later = region_of(particles, 2.5, 4.0);
    EXPECT_EQ(later.low, region.low);
    EXPECT_EQ(later.high, region.high);
    particles.owned.clear();
    const auto empty = region_of(particles, 2.5, 4.0);
    EXPECT_GT(empty.low[0], empty.high[0]);
}

TEST(InterfaceGeometry, FacetsOfAnotherDimensionAreRefused)
{
    Walls<2> walls(plate_settings<2>());
    EXPECT_THROW(set_interface_motion(walls, plate<3>(4, 2)), base::Error);
}

TEST(InterfaceGeometry, MotionWithinTheStep)
{
    auto batch = plate<2>(4, 2);
    for (std::size_t n = 0; n < 3; ++n) {
        batch.motion.velocity[2 * n + 1] = 2;
        batch.motion.acceleration[2 * n + 1] = -10;
    }
    Walls<2> walls(plate_settings<2>());
    set_interface_motion(walls, batch);
    walls.move(0.1);
    for (const auto& x : walls.facets().positions()) EXPECT_NEAR(x.y(), 0.2 - 0.05, 1e-15);
    EXPECT_NEAR(walls.facets().normal(0).y(), 1, 1e-15);
}

TEST(InterfaceGeometry, NewMotionOfTheSameFacetsKeepsTheLists)
{
    WetPlate<2> cast(6);
    cast.evaluate();
    EXPECT_FALSE(cast.walls.stale());
    set_interface_motion(cast.walls, cast.batch);
    EXPECT_FALSE(cast.walls.stale());
    cast.batch.facet_nodes.pop_back();
    cast.batch.facet_ids.pop_back();
    set_interface_motion(cast.walls, cast.batch);
    EXPECT_TRUE(cast.walls.stale());
}

TEST(InterfaceGeometry, JumpWorkIsForceTimesJump)
{
    WetPlate<2> cast(6);
    cast.evaluate();
    InterfaceLoads<2> loads(cast.walls.settings(), false);
    loads.begin(cast.walls, cast.batch.facet_ids.size());
    loads.add(cast.particles, cast.walls, cast.forces.on_wall, 1.0);
    auto after = cast.batch;
    for (std::size_t n = 0; n < after.node_ids.size(); ++n) after.motion.position[2 * n + 1] -= 1e-3;
    const double work = jump_work(loads.loads(), cast.walls, cast.batch, after).value();
    const auto total = resultant(loads.loads(), cast.walls, cast.batch, base::Communicator::self());
    EXPECT_NEAR(work, -1e-3 * total.force[1], 1e-12 * std::abs(total.force[1]));
    EXPECT_GT(work, 0);
}

TEST(InterfaceGeometry, ResultantIsTheSameOnAnyNumberOfRanks)
{
    const auto world = base::Communicator::world();
    WetPlate<2> cast(6);
    cast.evaluate();
    InterfaceLoads<2> all(cast.walls.settings(), false), mine(cast.walls.settings(), false);
    all.begin(cast.walls, cast.batch.facet_ids.size());
    all.add(cast.particles, cast.walls, cast.forces.on_wall, 1.0);
    mine.begin(cast.walls, cast.batch.facet_ids.size());
    auto share = cast.forces.on_wall; // every rank has the forces of some particles only
    for (std::size_t p = 0; p < share.size(); ++p)
        if (static_cast<int>(p) % world.size() != world.rank()) share[p].setZero();
    mine.add(cast.particles, cast.walls, share, 1.0);
    const auto expected = resultant(all.loads(), cast.walls, cast.batch, base::Communicator::self());
    const auto found = resultant(mine.loads(), cast.walls, cast.batch, world);
    EXPECT_EQ(found.force, expected.force);
    EXPECT_NEAR(found.moment[2], expected.moment[2], 1e-9 * std::abs(expected.moment[2]));
}

} // namespace
} // namespace sph

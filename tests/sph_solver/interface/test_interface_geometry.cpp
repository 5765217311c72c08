// SPDX-License-Identifier: MIT
#include "sph_solver/interface/mapping_report.hpp"
#include "tests/sph_solver/interface/wet_plate.hpp"

#include <array>

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
    const auto works = exchange_works(loads.loads(), cast.walls, {}, cast.batch, after);
    const double force = resultant(loads.loads(), cast.walls, cast.batch, {})[1].value();
    EXPECT_NEAR(works.jump.value(), -1e-3 * force, 1e-12 * std::abs(force));
    EXPECT_NEAR(works.path.value(), works.jump.value(), 1e-12 * std::abs(force)); // the walls have not moved in between
    EXPECT_GT(works.jump.value(), 0);
}

/// Two halves of a plate as two interfaces: walls, loads, forces and works are those of the whole one.
TEST(InterfaceGeometry, TwoInterfacesAreTheWholeOfTheirParts)
{
    WetPlate<2> whole(6), halves(6);
    std::array<coupler::FacetBatch, 2> parts;
    for (auto& part : parts) {
        part = whole.batch;
        part.facet_ids.clear();
        part.facet_nodes.clear();
    }
    for (std::size_t f = 0; f < whole.batch.facet_ids.size(); ++f) {
        auto& part = parts[f < 2 ? 0 : 1];
        part.facet_ids.push_back(whole.batch.facet_ids[f]);
        part.facet_nodes.push_back(whole.batch.facet_nodes[f]);
    }
    halves.batch = joined({&parts[0], &parts[1]});
    whole.evaluate();
    halves.evaluate();
    InterfaceLoads<2> of_whole(whole.walls.settings(), true), of_halves(whole.walls.settings(), true);
    for (auto [cast, loads] : {std::pair{&whole, &of_whole}, std::pair{&halves, &of_halves}}) {
        loads->begin(cast->walls, 6);
        loads->add(cast->particles, cast->walls, cast->forces.on_wall, 1.0);
    }
    const InterfacePlace second{2, parts[0].node_ids.size()};
    const double force = resultant(of_whole.loads(), whole.walls, whole.batch, {})[1].value();
    const double first_half = resultant(of_halves.loads(), halves.walls, parts[0], {})[1].value();
    const double second_half = resultant(of_halves.loads(), halves.walls, parts[1], second)[1].value();
    EXPECT_NEAR(first_half + second_half, force, 1e-12 * std::abs(force));
    EXPECT_NEAR(first_half / second_half, 0.5, 0.2);
    auto after = parts[1];
    for (std::size_t n = 0; n < after.node_ids.size(); ++n) after.motion.position[2 * n + 1] -= 1e-3;
    const auto works = exchange_works(of_halves.loads(), halves.walls, second, parts[1], after);
    EXPECT_NEAR(works.path.value(), -1e-3 * second_half, 1e-12 * std::abs(force));

    const auto part = part_of(of_halves.loads(), second.facet, 4, 2);
    ASSERT_EQ(part.corner_force.size(), 4u * 4 * 2);
    for (std::size_t f = 0; f < 4; ++f)
        EXPECT_NEAR(part.weighted_pressure[f].value(), of_whole.loads().weighted_pressure[2 + f].value(),
                    1e-9 * std::abs(force));
    const auto self = base::Communicator::self();
    EXPECT_EQ(examine_mapping(halves.walls, parts[1], second, 1.0, self).facets, 4);
    EXPECT_EQ(examine_mapping(halves.walls, parts[0], {}, 1.0, self).touched, 2);
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
    const auto expected = resultant(all.loads(), cast.walls, cast.batch, {});
    const auto part = resultant(mine.loads(), cast.walls, cast.batch, {});
    const auto found = world.total({part.begin(), part.end()});
    for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(found[a].value(), expected[a].value());
    EXPECT_NEAR(found[5].value(), expected[5].value(), 1e-9 * std::abs(expected[5].value()));
}

} // namespace
} // namespace sph

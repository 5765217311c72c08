// SPDX-License-Identifier: MIT
#include "coupler_lib/fake/facet_pressure.hpp"
#include "coupler_lib/fake/piston_surface.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

namespace {

using namespace coupler;

/// A vertical wall x = 0 from y = 0 to 2, the fluid on its right.
FacetBatch wall(double velocity, double acceleration)
{
    FacetBatch batch;
    batch.node_ids = {0, 1, 2};
    batch.facet_ids = {0, 1};
    batch.facet_nodes = {{0, 1, -1, -1}, {1, 2, -1, -1}};
    batch.motion = {{0, 0, 0, 1, 0, 2},
                    {velocity, 0, velocity, 0, velocity, 0},
                    {acceleration, 0, acceleration, 0, acceleration, 0}};
    return batch;
}

bool all(std::int64_t) { return true; }

TEST(FacetPressure, OfAHydrostaticHeadHasTheExactForceAndMoment)
{
    FacetPressure pressure({1e-3, 0, false}, {.kind = "hydrostatic", .level = 2.0, .density = 1000, .gravity = 10});
    pressure.measure(wall(0, 0), 0, 0, all);
    const auto sums = pressure.resultants(wall(0, 0));
    EXPECT_NEAR(sums[0].value(), -20000.0, 1e-8); // rho g H^2/2, pushed in -x
    EXPECT_NEAR(sums[1].value(), 0.0, 1e-8);
    EXPECT_NEAR(sums[2].value(), 20000.0 * 2.0 / 3.0, 1e-8); // at H/3
    EXPECT_NEAR(pressure.loads().weighted_pressure[0].value(), 15000.0, 1e-8);
}

TEST(FacetPressure, DoesWorkOverThePredictedMotionAndTheJump)
{
    FacetPressure pressure({0.1, 0, false}, {.kind = "constant", .value = 100});
    auto batch = wall(3.0, 4.0);
    pressure.measure(batch, 0, 0.1, all);
    EXPECT_NEAR(pressure.work().value(), -100 * 2 * (0.3 + 0.02), 1e-10);
    for (std::size_t k = 0; k < 6; k += 2) batch.motion.position[k] = 0.35;
    EXPECT_NEAR(pressure.jump_work(batch).value(), -100 * 2 * (0.35 - 0.32), 1e-10);
}

TEST(FacetPressure, RadiatesWithItsImpedance)
{
    FacetPressure pressure({0.1, 50.0, true}, {.kind = "constant", .value = 0});
    pressure.measure(wall(3.0, 4.0), 0, 0.1, all); // v = 3.2 at the middle of the step, out of the solid
    EXPECT_NEAR(pressure.resultants(wall(3.0, 4.0))[0].value(), -50 * 3.2 * 2, 1e-10);
}

TEST(PistonSurface, TurnsForcesAndPressuresIntoTheSameAxialLoad)
{
    PistonSurfaceConfig config;
    config.start = {2.0, 0.0};
    config.end = {0.0, 0.0};
    config.facets = 4;
    config.axis = {0.0, 3.0};
    const auto comm = base::Communicator::self();
    const PistonSurface surface(config, comm);
    EXPECT_EQ(surface.axis_cosine(), 1.0);
    SurfaceLoad averaged, conservative;
    averaged.pressure.assign(4, 70.0);
    for (const double share : {0.5, 1.0, 1.0, 1.0, 0.5})
        conservative.force.insert(conservative.force.end(), {0.0, -70.0 * 0.5 * share});
    EXPECT_NEAR(surface.axial(averaged), -70.0, 1e-12);
    EXPECT_NEAR(surface.axial(conservative), -70.0, 1e-12);
    SolidReport a, b;
    surface.resultants(averaged, 0.1, -70.0, a);
    surface.resultants(conservative, 0.1, -70.0, b);
    EXPECT_NEAR(a.force[1], -140.0, 1e-12);
    EXPECT_NEAR(a.moment[2], -140.0, 1e-12);
    EXPECT_NEAR(b.moment[2], -140.0, 1e-12);
}

} // namespace

// SPDX-License-Identifier: MIT
// The audit of the interface, the acceleration filter and the guards: pure parts of the coupling.
#include "coupler_lib/coupling/acceleration_filter.hpp"
#include "coupler_lib/coupling/audit.hpp"
#include "coupler_lib/coupling/surface_guards.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace {

TEST(Audit, ComparesTheWorksOfBothSides)
{
    coupler::InterfaceAudit audit(2);
    coupler::FluidReport fluid;
    coupler::SolidReport solid;
    fluid.work_on_solid = 9.0;
    fluid.jump_work = 1.0;
    solid.work = 10.0;
    audit.record({1, 0.1, 0.1}, fluid, solid);
    EXPECT_EQ(audit.work_on_fluid(), -10.0);
    EXPECT_EQ(audit.mismatch(), 0.0);
    solid.work = 6.0; // the peak stays 10
    fluid.work_on_solid = 4.0;
    audit.record({2, 0.2, 0.1}, fluid, solid);
    EXPECT_NEAR(audit.mismatch(), 0.1, 1e-15);
    fluid.work_on_solid = 5.0;
    audit.record({3, 0.3, 0.1}, fluid, solid);
    EXPECT_EQ(audit.mismatch(), 0.0);
    EXPECT_NEAR(audit.worst_mismatch(), 0.1, 1e-15);
}

TEST(Audit, HasAValueForEveryColumn)
{
    for (const int dimension : {2, 3}) {
        coupler::InterfaceAudit audit(dimension);
        audit.record({4, 0.5, 0.1}, {}, {});
        EXPECT_EQ(audit.columns().size(), audit.row().size());
        EXPECT_EQ(audit.columns()[0], "t[s]");
        EXPECT_EQ(audit.row()[0], 0.5);
    }
}

coupler::SurfaceMotion moving(double velocity, double acceleration) { return {{0.0}, {velocity}, {acceleration}}; }

TEST(AccelerationFilter, TakesTheMeanOverItsSteps)
{
    coupler::AccelerationFilter filter(2);
    const double times[] = {0.0, 0.1, 0.3, 0.4}, velocities[] = {0.0, 1.0, 2.0, 5.0};
    const double expected[] = {0.0, 10.0, 2.0 / 0.3, 4.0 / 0.3}; // no step yet, then as far back as there is
    for (int k = 0; k < 4; ++k) {
        auto motion = moving(velocities[k], 7.0);
        filter.apply(times[k], motion);
        EXPECT_NEAR(motion.acceleration[0], expected[k], 1e-12) << "state " << k;
    }
}

TEST(AccelerationFilter, OfOneStepIsTheLastMean)
{
    coupler::AccelerationFilter filter(1);
    auto motion = moving(1.0, 7.0);
    filter.apply(0.0, motion);
    motion = moving(3.0, 7.0);
    filter.apply(0.5, motion);
    EXPECT_EQ(motion.acceleration[0], 4.0);
}

TEST(AccelerationFilter, LeavesNodalValuesAlone)
{
    coupler::AccelerationFilter filter(0);
    auto motion = moving(1.0, 7.0);
    filter.apply(0.0, motion);
    filter.apply(1.0, motion);
    EXPECT_EQ(motion.acceleration[0], 7.0);
}

coupler::WetSurface bar()
{
    return {2, {10, 11, 12}, {0, 0, 1, 0, 2, 0}, {5, 6}, {{{0, 1, -1, -1}}, {{1, 2, -1, -1}}}};
}

coupler::SurfaceMotion at_rest() { return {{0, 0, 1, 0, 2, 0}, std::vector<double>(6), std::vector<double>(6)}; }

std::string refusal(coupler::MotionGuard& guard, const coupler::SurfaceMotion& motion)
{
    try {
        guard.check(bar(), motion, "'solid' (rank 1)");
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::numerical_failure);
        return error.what();
    }
    return "";
}

TEST(MotionGuard, NamesTheNodeThatIsNotANumber)
{
    coupler::MotionGuard guard(bar(), 1.0);
    auto motion = at_rest();
    motion.acceleration[3] = std::numeric_limits<double>::quiet_NaN();
    const std::string message = refusal(guard, motion);
    EXPECT_NE(message.find("node 11 of facet 5 (reference (1, 0)"), std::string::npos) << message;
    EXPECT_NE(message.find("rank 1"), std::string::npos) << message;
}

TEST(MotionGuard, StopsAJumpButNotAStep)
{
    coupler::MotionGuard guard(bar(), 0.5); // of a mean facet size of 1 m
    auto motion = at_rest();
    EXPECT_EQ(refusal(guard, motion), "");
    motion.position[5] = 0.49;
    EXPECT_EQ(refusal(guard, motion), "");
    motion.position[5] = 1.0;
    const std::string message = refusal(guard, motion);
    EXPECT_NE(message.find("wet node 12 of facet 6 jumped by 0.51 m"), std::string::npos) << message;
}

TEST(LoadGuard, NamesTheFacetBeyondTheLimit)
{
    const auto surface = bar();
    coupler::FacetBatch batch{2, surface.node_ids, surface.facet_ids, surface.facet_nodes, at_rest()};
    coupler::FacetLoads loads;
    loads.corner_force.resize(2 * 4 * 2);
    loads.corner_force[(4 + 1) * 2 + 1].add(-1001.0); // facet 6, second corner, y
    EXPECT_NO_THROW(coupler::check_loads(batch, loads, 1002.0, "'fluid' (rank 0)"));
    try {
        coupler::check_loads(batch, loads, 1000.0, "'fluid' (rank 0)");
        FAIL() << "a load of 1001 Pa passed a limit of 1000 Pa";
    } catch (const base::Error& error) {
        EXPECT_NE(std::string(error.what()).find("facet 6 at (1.5, 0)"), std::string::npos) << error.what();
    }
}

TEST(SurfaceCheck, RefusesBadSurfaces)
{
    const auto refused = [](coupler::WetSurface surface) {
        EXPECT_THROW(coupler::check_surface(surface, "'solid'"), base::Error);
    };
    EXPECT_NO_THROW(coupler::check_surface(bar(), "'solid'"));
    auto surface = bar();
    surface.facet_nodes[1][1] = 3;
    refused(surface);
    surface = bar();
    surface.facet_nodes[1] = {1, 1, -1, -1};
    refused(surface);
    surface = bar();
    surface.facet_nodes[0] = {0, 1, 2, -1};
    refused(surface);
    surface = bar();
    surface.reference.pop_back();
    refused(surface);
}

} // namespace

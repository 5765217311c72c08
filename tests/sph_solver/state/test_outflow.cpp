// SPDX-License-Identifier: MIT
#include "sph_solver/state/outflow.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

/// The second one is beyond x = 1.
Particles<2> three_particles()
{
    Particles<2> particles;
    particles.resize(3);
    particles.own_all();
    particles.id = {10, 11, 12};
    particles.position = {{0.5, 0.0}, {1.5, 2.0}, {0.9, 0.0}};
    particles.volume = {1.0, 1.0, 1.0};
    particles.mass = {1000.0, 1100.0, 1000.0};
    particles.momentum = {{0.0, 0.0}, {2200.0, -1100.0}, {0.0, 0.0}};
    return particles;
}

TEST(Outflow, TakesOutWhatIsBeyondThePlaneAndCountsIt)
{
    Particles<2> particles = three_particles();
    const Tait eos{1000.0, 10.0};
    Outflow<2> outflow({{Vec<2>(1.0, 0.0), Vec<2>(2.0, 0.0)}}, eos, Vec<2>(0.0, -10.0));
    outflow.remove(particles);
    outflow.remove(particles);
    EXPECT_EQ(particles.id, (std::vector<std::int64_t>{10, 12}));
    EXPECT_EQ(particles.owned, (std::vector<int>{0, 1}));
    const OutflowTotals& out = outflow.totals();
    EXPECT_EQ(out.particles, 1);
    EXPECT_DOUBLE_EQ(out.mass.value(), 1100.0);
    EXPECT_DOUBLE_EQ(out.momentum[0].value(), 2200.0);
    EXPECT_DOUBLE_EQ(out.momentum[1].value(), -1100.0);
    EXPECT_DOUBLE_EQ(out.kinetic.value(), 0.5 * 1100.0 * 5.0);
    EXPECT_DOUBLE_EQ(out.potential.value(), 1100.0 * 10.0 * 2.0);
    EXPECT_DOUBLE_EQ(out.internal.value(), 1100.0 * eos.specific_internal_energy(1100.0));
}

/// What is marked goes too, and is told apart from what has left through an opening.
TEST(Outflow, CountsWhatIsTrappedAsAPartOfAllThatIsGone)
{
    Particles<2> particles = three_particles();
    particles.mass[2] = 1200.0;
    particles.momentum[2] = {0.0, 1200.0};
    Outflow<2> outflow({{Vec<2>(1.0, 0.0), Vec<2>(2.0, 0.0)}}, Tait{1000.0, 10.0}, Vec<2>(0.0, 0.0));
    outflow.remove(particles, {0, 0, 1});
    EXPECT_EQ(particles.id, (std::vector<std::int64_t>{10}));
    EXPECT_EQ(outflow.totals().particles, 2);
    EXPECT_DOUBLE_EQ(outflow.totals().mass.value(), 2300.0);
    EXPECT_EQ(outflow.trapped().particles, 1);
    EXPECT_DOUBLE_EQ(outflow.trapped().mass.value(), 1200.0);
    EXPECT_DOUBLE_EQ(outflow.trapped().kinetic.value(), 600.0);
    EXPECT_DOUBLE_EQ(outflow.totals().momentum[1].value(), 100.0);
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/parallel/work_meter.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

TEST(WorkMeter, CostsAreThoseOfAllRanksTogether)
{
    const auto comm = base::Communicator::world();
    WorkMeter meter(true);
    EXPECT_EQ(meter.cost(Work::pair), 0.0);
    const double share = comm.rank() + 1.0; // uneven work at the same speed
    meter.add_seconds(Work::pair, 3e-3 * share);
    meter.add_seconds(Work::image, 1e-3 * share);
    meter.add_counts({0.0, 5e5 * share, 5e3 * share}, 2);
    EXPECT_DOUBLE_EQ(meter.calibrate(comm), 4e-3 * share);
    EXPECT_NEAR(meter.cost(Work::pair), 3e-9, 1e-20);
    EXPECT_NEAR(meter.cost(Work::image), 1e-7, 1e-18);
    EXPECT_EQ(meter.cost(Work::particle), 0.0);
    EXPECT_EQ(meter.calibrate(comm), 0.0);            // nothing since
    EXPECT_NEAR(meter.cost(Work::pair), 3e-9, 1e-20); // but what is known stays
}

TEST(WorkMeter, OlderMeasurementsFade)
{
    const auto comm = base::Communicator::world();
    WorkMeter meter(true);
    for (const double cost : {1.0, 1.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0}) {
        meter.add_seconds(Work::particle, cost);
        meter.add_counts({1.0, 0.0, 0.0}, 1);
        meter.calibrate(comm);
    }
    EXPECT_GT(meter.cost(Work::particle), 2.8);
    EXPECT_LT(meter.cost(Work::particle), 3.0);
}

TEST(WorkMeter, UnwantedItMeasuresNothing)
{
    WorkMeter meter(false);
    {
        const auto scope = meter.measure(Work::pair);
    }
    EXPECT_EQ(meter.calibrate(base::Communicator::self()), 0.0);
}

} // namespace
} // namespace sph

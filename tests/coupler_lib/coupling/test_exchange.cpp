// SPDX-License-Identifier: MIT
// The exchange against brute force, for every way to deal the ranks to a fluid and a solid.
#include "coupled_world.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <set>

namespace {

using namespace coupled_test;

/// Runs `fluid` or `solid`, by role, for every split of the ranks.
void for_every_split(const std::function<void(coupler::Participant&)>& fluid,
                     const std::function<void(coupler::Participant&)>& solid)
{
    for (const int fluid_ranks : all_splits()) {
        coupler::Participant me(settings_for(fluid_ranks));
        me.role() == "fluid" ? fluid(me) : solid(me);
        MPI_Barrier(MPI_COMM_WORLD);
    }
}

coupler::RegionBox my_slice(const coupler::Participant& fluid)
{
    const double width = 4.2 / fluid.comm().size();
    return slice(-0.1 + width * fluid.comm().rank(), -0.1 + width * (fluid.comm().rank() + 1));
}

/// Ids of the facets whose current box touches the slice: by brute force over the whole surface.
std::set<std::int64_t> expected_facets(const coupler::WetSurface& whole, const coupler::RegionBox& box, int step)
{
    const auto motion = motion_of(whole, step);
    std::set<std::int64_t> ids;
    for (std::size_t facet = 0; facet < whole.facet_ids.size(); ++facet) {
        double low = 1e30, high = -1e30;
        for (const int node : whole.facet_nodes[facet]) {
            if (node < 0) continue;
            const double x = motion.position[static_cast<std::size_t>(node * whole.dimension)];
            low = std::min(low, x);
            high = std::max(high, x);
        }
        if (low <= box.high[0] && high >= box.low[0]) ids.insert(whole.facet_ids[facet]);
    }
    return ids;
}

void expect_batch(const coupler::FacetBatch& batch, const coupler::WetSurface& whole, const coupler::RegionBox& box,
                  int step)
{
    const std::set<std::int64_t> got(batch.facet_ids.begin(), batch.facet_ids.end());
    EXPECT_EQ(got, expected_facets(whole, box, step)) << "step " << step;
    EXPECT_TRUE(std::is_sorted(batch.facet_ids.begin(), batch.facet_ids.end()));
    EXPECT_TRUE(std::adjacent_find(batch.node_ids.begin(), batch.node_ids.end(), std::greater_equal<>()) ==
                batch.node_ids.end());
    const auto motion = motion_of(whole, step);
    for (std::size_t facet = 0; facet < batch.facet_ids.size(); ++facet) {
        const auto there = static_cast<std::size_t>(find_id(whole.facet_ids, batch.facet_ids[facet]));
        for (std::size_t k = 0; k < 4; ++k) {
            const int here_node = batch.facet_nodes[facet][k], there_node = whole.facet_nodes[there][k];
            EXPECT_EQ(here_node < 0, there_node < 0);
            if (here_node < 0 || there_node < 0) continue;
            for (int d = 0; d < whole.dimension; ++d) {
                const auto here = static_cast<std::size_t>(here_node * whole.dimension + d);
                const auto source = static_cast<std::size_t>(there_node * whole.dimension + d);
                EXPECT_EQ(batch.motion.position[here], motion.position[source]);
                EXPECT_EQ(batch.motion.velocity[here], motion.velocity[source]);
                EXPECT_EQ(batch.motion.acceleration[here], motion.acceleration[source]);
            }
        }
    }
}

class Exchange : public testing::TestWithParam<int> {};

TEST_P(Exchange, SendsEveryFluidRankTheFacetsInItsRegion)
{
    const auto whole = whole_surface(GetParam(), 3);
    constexpr int steps = 5;
    for_every_split(
        [&](coupler::Participant& me) {
            coupler::FluidInterface wet(me, {}, GetParam());
            coupler::FacetBatch batch;
            batch.dimension = GetParam();
            for (int step = -1; step < steps; ++step) {
                auto box = my_slice(me);
                box.low[0] += 0.05 * step; // the region moves, facets come and go
                const coupler::Window window{step, step < 0 ? 0.0 : 0.1 * step, step < 0 ? 0.0 : 0.1,
                                             step == steps - 1};
                wet.send(window, box, step < 0 ? coupler::FacetLoads{} : no_loads(batch), batch, {});
                coupler::SolidReport report;
                batch = wet.receive(report);
                expect_batch(batch, whole, box, step);
                EXPECT_EQ(report.work, 100.0 + step);
            }
        },
        [&](coupler::Participant& me) {
            const auto mine = dealt_surface(whole, me.comm().rank(), me.comm().size(), 5);
            coupler::SolidInterface wet(me, {}, mine);
            coupler::SurfaceLoad load;
            coupler::FluidReport report;
            for (bool last = false; !last;) {
                const auto window = wet.receive(load, report);
                EXPECT_EQ(load.force, std::vector<double>(mine.reference.size(), 0.0));
                coupler::SolidReport answer;
                answer.work = 100.0 + static_cast<double>(window.step);
                wet.send(motion_of(mine, static_cast<int>(window.step)), answer);
                last = window.last;
            }
        });
}

/// Greeting and one exchange; the fluid's loads are made by `fill`, the solid looks at what arrives with `look`.
void one_load(int dimension, coupler::LoadKind kind,
              const std::function<void(coupler::Participant&, const coupler::FacetBatch&, coupler::FacetLoads&)>& fill,
              const std::function<void(const coupler::WetSurface&, const coupler::SurfaceLoad&)>& look)
{
    const auto whole = whole_surface(dimension, 3);
    coupler::InterfaceSettings settings;
    settings.load = kind;
    settings.impedance = 1.5e6;
    for_every_split(
        [&](coupler::Participant& me) {
            coupler::FluidInterface wet(me, settings, dimension);
            coupler::SolidReport report;
            coupler::FacetBatch batch;
            batch.dimension = dimension;
            wet.send({-1, 0, 0}, slice(-9, 9), {}, batch, {});
            batch = wet.receive(report);
            auto loads = no_loads(batch);
            fill(me, batch, loads);
            wet.send({0, 0, 0.1, true}, slice(-9, 9), loads, batch, {});
            wet.receive(report);
        },
        [&](coupler::Participant& me) {
            const auto mine = dealt_surface(whole, me.comm().rank(), me.comm().size(), 5);
            coupler::SolidInterface wet(me, settings, mine);
            coupler::SurfaceLoad load;
            coupler::FluidReport report;
            wet.receive(load, report);
            wet.send(motion_of(mine, -1), {});
            wet.receive(load, report);
            EXPECT_EQ(load.impedance, 1.5e6);
            look(mine, load);
            wet.send(motion_of(mine, -1), {});
        });
}

/// Virtual work with the test field u, then total force, then the moment about the origin (z only in 2D).
struct Resultants {
    double work = 0, force[3] = {0, 0, 0}, moment[3] = {0, 0, 0}, size = 0;
    void add(const double* u, const double* x, const double* f, int dimension)
    {
        for (int d = 0; d < dimension; ++d) {
            work += f[d] * u[d];
            force[d] += f[d];
            size += std::abs(f[d] * u[d]) + std::abs(f[d]);
        }
        moment[2] += x[0] * f[1] - x[1] * f[0];
        if (dimension == 2) return;
        moment[0] += x[1] * f[2] - x[2] * f[1];
        moment[1] += x[2] * f[0] - x[0] * f[2];
    }
};

TEST_P(Exchange, KeepsVirtualWorkForceAndMoment)
{
    const int dimension = GetParam();
    const auto whole = whole_surface(dimension, 3);
    const auto positions = motion_of(whole, -1).position;
    const auto loads = random_loads(whole, 500, 11);
    Resultants sent; // every rank adds up all loads: the answer
    for (const PointLoad& load : loads) {
        const auto facet = static_cast<std::size_t>(find_id(whole.facet_ids, load.facet_id));
        double u[3] = {0, 0, 0}, x[3] = {0, 0, 0};
        for (std::size_t k = 0; k < 4 && whole.facet_nodes[facet][k] >= 0; ++k) {
            const int node = whole.facet_nodes[facet][k];
            for (int d = 0; d < dimension; ++d) {
                u[d] += load.shape[k] * nodal_value(whole.node_ids[static_cast<std::size_t>(node)], d + 40, 0);
                x[d] += load.shape[k] * positions[static_cast<std::size_t>(node * dimension + d)];
            }
        }
        sent.add(u, x, load.force.data(), dimension);
    }
    Resultants got;
    std::vector<double> sums;
    one_load(
        dimension, coupler::LoadKind::conservative,
        [&](coupler::Participant& me, const coupler::FacetBatch& batch, coupler::FacetLoads& mine) {
            for (std::size_t k = 0; k < loads.size(); ++k)
                if (static_cast<int>(k) % me.comm().size() == me.comm().rank()) add_load(mine, batch, loads[k]);
        },
        [&](const coupler::WetSurface& mine, const coupler::SurfaceLoad& load) {
            const auto x = motion_of(mine, -1).position;
            for (std::size_t node = 0; node < mine.node_ids.size(); ++node) {
                double u[3];
                for (int d = 0; d < dimension; ++d) u[d] = nodal_value(mine.node_ids[node], d + 40, 0);
                const std::size_t at = node * static_cast<std::size_t>(dimension);
                got.add(u, &x[at], &load.force[at], dimension);
            }
        });
    const auto splits = static_cast<double>(all_splits().size());
    EXPECT_NEAR(world_sum(got.work), splits * sent.work, 1e-12 * sent.size);
    for (int d = 0; d < 3; ++d) {
        EXPECT_NEAR(world_sum(got.force[d]), splits * sent.force[d], 1e-12 * sent.size);
        EXPECT_NEAR(world_sum(got.moment[d]), splits * sent.moment[d], 4e-12 * sent.size);
    }
}

TEST_P(Exchange, AveragesPressureWhereTheFacetIsCovered)
{
    const int dimension = GetParam();
    const auto whole = whole_surface(dimension, 3);
    auto loads = random_loads(whole, 200, 13);
    one_load(
        dimension, coupler::LoadKind::averaged,
        [&](coupler::Participant& me, const coupler::FacetBatch& batch, coupler::FacetLoads& mine) {
            mine.full_weight.assign(batch.facet_ids.size(), 2e-3);
            for (std::size_t k = 0; k < loads.size(); ++k)
                if (static_cast<int>(k) % me.comm().size() == me.comm().rank()) add_load(mine, batch, loads[k]);
        },
        [&](const coupler::WetSurface& mine, const coupler::SurfaceLoad& load) {
            EXPECT_TRUE(load.force.empty());
            EXPECT_EQ(load.pressure.size(), mine.facet_ids.size());
            for (std::size_t facet = 0; facet < load.pressure.size(); ++facet) {
                double weight = 0, sum = 0;
                for (const PointLoad& one : loads) {
                    if (one.facet_id != mine.facet_ids[facet]) continue;
                    weight += one.weight;
                    sum += one.weight * one.pressure;
                }
                const double expected = weight >= 0.3 * 2e-3 ? sum / weight : 0.0;
                EXPECT_NEAR(load.pressure[facet], expected, 1e-8) << "facet " << mine.facet_ids[facet];
            }
        });
}

INSTANTIATE_TEST_SUITE_P(InTwoAndThreeDimensions, Exchange, testing::Values(2, 3));

TEST(ExchangeSums, DoNotDependOnWhoCarriesTheLoads)
{
    const auto whole = whole_surface(2, 3);
    const auto loads = random_loads(whole, 3000, 17);
    std::vector<std::vector<double>> seen;
    for (int deal = 0; deal < 3; ++deal) {
        std::size_t split = 0;
        one_load(
            2, coupler::LoadKind::conservative,
            [&](coupler::Participant& me, const coupler::FacetBatch& batch, coupler::FacetLoads& mine) {
                const int ranks = me.comm().size(), rank = me.comm().rank();
                for (std::size_t k = 0; k < loads.size(); ++k) {
                    const std::size_t turn = deal == 1 ? loads.size() - 1 - k : k; // another order, too
                    const int carrier =
                        deal == 2 ? 0 : static_cast<int>((turn * 7 + turn / 3) % static_cast<std::size_t>(ranks));
                    if (carrier == rank) add_load(mine, batch, loads[turn]);
                }
            },
            [&](const coupler::WetSurface&, const coupler::SurfaceLoad& load) {
                if (deal == 0) seen.push_back(load.force);
                EXPECT_EQ(load.force, seen[split]) << "deal " << deal; // every bit
                ++split;
            });
    }
}

} // namespace

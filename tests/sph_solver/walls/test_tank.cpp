// SPDX-License-Identifier: MIT
#include "sph_solver/setup/initial_state.hpp"
#include "sph_solver/time/energy_ledger.hpp"
#include "sph_solver/time/fluid_step.hpp"
#include "sph_solver/time/time_step.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

constexpr double width = 0.1, level = 0.14, gravity = 9.81, spacing = 5e-3;

FluidModel<2> tank_model()
{
    return {CubicSpline<2>(1.23 * spacing), Tait{1000, 30}, VanAlbada{}, Vec<2>(0, -gravity)};
}

/// Floor and back wall, closed in front by a rigid wall and, flush below it, a gate of small facets whose corner dips
/// into the
/// floor by `dip`.
Walls<2> closed_tank(double dip)
{
    WallSettings<2> settings;
    settings.spacing = spacing;
    settings.support = 2 * 1.23 * spacing;
    settings.gravity = Vec<2>(0, -gravity);
    Walls<2> walls(settings);
    walls.add_fixed({"tank"}, {1.2, 0, 0, 0, 0, 0.2}, {{0, 1, -1, -1}, {1, 2, -1, -1}});
    walls.add_fixed({"front"}, {width, 0.2, width, 0.079}, {{0, 1, -1, -1}});
    VertexMotion<2> motion;
    std::vector<WallFacet<2>> facets;
    const auto add = [&](double x, double y) {
        motion.position.emplace_back(x, y);
        motion.velocity.push_back(Vec<2>::Zero());
        motion.acceleration.push_back(Vec<2>::Zero());
    };
    for (int k = 0; k <= 20; ++k) add(width, 0.079 - (0.079 + dip) * k / 20);
    for (int k = 0; k <= 20; ++k) add(width + 0.005, -dip + (0.079 + dip) * k / 20);
    for (int k = 0; k < 41; ++k) {
        WallFacet<2> facet;
        facet.vertex = {k, k + 1};
        facet.source = k;
        facet.corner = {0, 1};
        facets.push_back(facet);
    }
    walls.set_moving({"gate"}, motion, facets);
    return walls;
}

Particles<2> still_water(const Tait& eos)
{
    const int columns = 20, rows = 28;
    Particles<2> particles;
    particles.resize(static_cast<std::size_t>(columns * rows));
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const auto number = static_cast<int>(i);
        particles.id[i] = number;
        particles.position[i] = spacing * Vec<2>(number % columns + 0.5, number / columns + 0.5);
        particles.volume[i] = spacing * spacing;
        particles.mass[i] = hydrostatic_density(eos, gravity, level - particles.position[i].y()) * particles.volume[i];
        particles.momentum[i].setZero();
    }
    particles.own_all();
    return particles;
}

class Tank : public testing::TestWithParam<double> {};

TEST_P(Tank, StillWaterKeepsStill)
{
    const auto model = tank_model();
    const auto comm = base::Communicator::self();
    auto walls = closed_tank(GetParam());
    auto particles = still_water(model.eos);
    NeighbourSearch<2> search(model.kernel.support(), 0.15 * model.kernel.support());
    Domain<2> domain(comm, search.grid());
    Outflow<2> outflow;
    base::TimerTree timers;
    FluidStep<2> step(model, RungeKutta("rk2"), {domain, search, walls, outflow, timers});
    EnergyLedger<2> ledger(model);
    step.add_observer(ledger);
    step.prepare(particles);
    const auto start = ledger.balance(particles, outflow, comm);
    const TimeStepSettings pace{.cfl = 0.6, .smoothing_length = 1.23 * spacing, .sound_speed = 30};
    TimeStep time_step(pace);
    double largest = 0;
    for (double time = 0; time < 0.05;) {
        const double dt = time_step.next(particles, comm);
        step.advance(particles, dt);
        time += dt;
        const auto now = ledger.balance(particles, outflow, comm);
        largest = std::max(largest, now.kinetic);
        EXPECT_NEAR(now.mass, start.mass, 1e-12 * start.mass);
    }
    const double potential = 0.5 * 1000 * gravity * level * level * width; // 9.61 J/m
    EXPECT_LT(largest, 1e-7 * potential);
    const auto end = ledger.balance(particles, outflow, comm);
    EXPECT_LT(std::abs(end.total - start.total), 1e-6);
    EXPECT_LT(std::abs(end.balance_error), 1e-8);
    walls.find_contacts(particles);
    EXPECT_EQ(walls.penetration().count, 0);
    const double pressure_scale = 1000 * gravity * level;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double depth = level - particles.position[i].y();
        const double expected = model.eos.pressure(hydrostatic_density(model.eos, gravity, depth));
        EXPECT_NEAR(particles.pressure[i], expected, 0.02 * pressure_scale);
    }
}

INSTANTIATE_TEST_SUITE_P(GateClosed, Tank, testing::Values(0.0, 0.06e-3));

} // namespace
} // namespace sph

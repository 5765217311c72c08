// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/setup/initial_state.hpp"
#include "sph_solver/setup/make_model.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sph {
namespace {

const base::Communicator& world()
{
    static const base::Communicator comm = base::Communicator::world();
    return comm;
}

FluidConfig tank(double spacing)
{
    FluidConfig config;
    config.domain.gravity = {0.0, -9.81};
    config.resolution.spacing = spacing;
    config.liquid.sound_speed = 30.0;
    config.water.push_back({.low = {0.0, 0.0}, .high = {0.1, 0.14}});
    return config;
}

TEST(HydrostaticState, BalancesGravity)
{
    const Tait eos{1000.0, 30.0};
    const double depth = 0.1, step = 1e-5;
    const double slope = (eos.pressure(hydrostatic_density(eos, 9.81, depth + step)) -
                          eos.pressure(hydrostatic_density(eos, 9.81, depth - step))) /
                         (2.0 * step);
    EXPECT_NEAR(slope, 9.81 * hydrostatic_density(eos, 9.81, depth), 1e-4);
    EXPECT_EQ(hydrostatic_density(eos, 9.81, 0.0), 1000.0);
    EXPECT_EQ(hydrostatic_density(eos, 9.81, -1.0), 1000.0);
}

TEST(InitialParticles, FillTheBoxHalfASpacingFromItsFaces)
{
    const FluidConfig config = tank(0.01);
    const auto particles = initial_particles(config, make_model<2>(config), base::Communicator::self());
    ASSERT_EQ(particles.size(), 140U);
    double volume = 0.0, lowest = 1.0, highest = 0.0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        volume += particles.volume[i];
        lowest = std::min(lowest, particles.position[i][1]);
        highest = std::max(highest, particles.position[i][1]);
        EXPECT_DOUBLE_EQ(particles.mass[i] / particles.volume[i],
                         hydrostatic_density(Tait{1000.0, 30.0}, 9.81, 0.14 - particles.position[i][1]));
    }
    EXPECT_NEAR(volume, 0.014, 1e-15);
    EXPECT_NEAR(lowest, 0.005, 1e-15);
    EXPECT_NEAR(highest, 0.135, 1e-15);
}

struct Made {
    std::int64_t id;
    double x, y, mass;
    friend bool operator==(const Made&, const Made&) = default;
};

std::vector<Made> list(const Particles<2>& particles)
{
    std::vector<Made> made;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        made.push_back({particles.id[i], particles.position[i][0], particles.position[i][1], particles.mass[i]});
    }
    return made;
}

TEST(InitialParticles, AreTheSameOnAnyNumberOfRanks)
{
    FluidConfig config = tank(0.01);
    config.water.push_back({.low = {0.2, 0.0}, .high = {0.25, 0.05}, .velocity = {{"1"}, {"0"}}});
    const auto model = make_model<2>(config);
    const auto together = world().gather_all(list(initial_particles(config, model, world())));
    EXPECT_EQ(together, list(initial_particles(config, model, base::Communicator::self())));
}

TEST(InitialParticles, OfTheSecondBodyHaveItsVelocity)
{
    FluidConfig config = tank(0.01);
    config.water.push_back({.low = {0.2, 0.0}, .high = {0.25, 0.05}, .velocity = {{"1"}, {"-2"}}});
    const auto particles = initial_particles(config, make_model<2>(config), base::Communicator::self());
    ASSERT_EQ(particles.size(), 165U);
    EXPECT_EQ(particles.momentum[139], Vec<2>(0.0, 0.0));
    EXPECT_EQ(particles.momentum[140], particles.mass[140] * Vec<2>(1.0, -2.0));
    EXPECT_GT(particles.position[140][0], 0.2);
}

TEST(InitialParticles, DiscOnRingsHasItsAreaAndCentre)
{
    FluidConfig config = tank(0.02);
    config.domain.gravity = {0.0, 0.0};
    config.initial.state = "uniform";
    config.water = {{.shape = "disc", .centre = {1.0, 2.0}, .radius = 0.5}};
    const auto particles = initial_particles(config, make_model<2>(config), base::Communicator::self());
    double area = 0.0, reach = 0.0;
    Vec<2> centre = Vec<2>::Zero();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        area += particles.volume[i];
        centre += particles.volume[i] * particles.position[i];
        reach = std::max(reach, (particles.position[i] - Vec<2>(1.0, 2.0)).norm());
    }
    EXPECT_NEAR(area, std::numbers::pi * 0.25, 1e-12);
    EXPECT_NEAR((centre / area - Vec<2>(1.0, 2.0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(reach, 0.5 * 25.0 / 25.5, 1e-12); // 25 rings, half a spacing beyond the last
    EXPECT_EQ(particles.size(), 1U + 3U * 25U * 26U);
}

TEST(InitialParticles, UniformPressureGivesItsDensity)
{
    FluidConfig config = tank(0.02);
    config.initial.state = "uniform";
    config.initial.pressure = {"500"};
    const auto model = make_model<2>(config);
    const auto particles = initial_particles(config, model, base::Communicator::self());
    EXPECT_NEAR(model.eos.pressure(particles.mass[3] / particles.volume[3]), 500.0, 1e-8);
}

TEST(InitialParticles, RefuseOverlapsAndSlivers)
{
    FluidConfig config = tank(0.01);
    config.water.push_back({.low = {0.05, 0.0}, .high = {0.2, 0.05}});
    EXPECT_THROW(initial_particles(config, make_model<2>(config), base::Communicator::self()), base::Error);
    config.water = {{.low = {0.0, 0.0}, .high = {0.1, 0.001}}};
    EXPECT_THROW(initial_particles(config, make_model<2>(config), base::Communicator::self()), base::Error);
}

TEST(InitialParticles, FillACuboid)
{
    FluidConfig config = tank(0.05);
    config.domain.dimension = 3;
    config.domain.gravity = {0.0, 0.0, -9.81};
    config.water = {{.low = {0, 0, 0}, .high = {0.1, 0.2, 0.3}}};
    const auto particles = initial_particles(config, make_model<3>(config), base::Communicator::self());
    ASSERT_EQ(particles.size(), 48U);
    EXPECT_NEAR(particles.volume[0], 1.25e-4, 1e-18);
    EXPECT_NEAR((particles.position[47] - Vec<3>(0.075, 0.175, 0.275)).norm(), 0.0, 1e-15);
    EXPECT_DOUBLE_EQ(particles.mass[47] / particles.volume[47], hydrostatic_density(Tait{1000.0, 30.0}, 9.81, 0.025));
}

} // namespace
} // namespace sph

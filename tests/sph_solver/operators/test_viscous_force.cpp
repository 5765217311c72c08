// SPDX-License-Identifier: MIT
#include "sph_solver/operators/viscous_force.hpp"
#include "tests/sph_solver/support/reached_neighbours.hpp"
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

constexpr double mu = 3.0;
constexpr int side = 12;

template<int D> FluidModel<D> plain_model()
{
    return {CubicSpline<D>(1.23), Tait{1000, 30}, VanAlbada{}, Vec<D>::Zero()};
}

/// A square or cube of unit spacing whose velocity along x is a function of y.
template<int D, class Profile> Particles<D> stream(Profile profile, double jitter)
{
    auto particles = sample::jittered_lattice<D>(side, 1.0, jitter, 1000.0);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        particles.velocity[i].setZero();
        particles.velocity[i][0] = profile(particles.position[i][1]);
        particles.density[i] = 1000.0;
        particles.pressure[i] = 0.0;
        particles.sound_speed[i] = 30.0;
    }
    return particles;
}

template<int D> std::vector<Vec<D>> forces_between(const Particles<D>& particles)
{
    PairRecords<D> records;
    records.load_states(particles, Tait{1000, 30}, particles.owned);
    Rates<D> rates;
    rates.reset(particles.size());
    std::vector<Vec<D>> sums(particles.size(), Vec<D>::Zero());
    ViscousForce<D>(mu, plain_model<D>())
        .add(rates, sums, records, sample::reached_neighbours(particles, 2.46), particles.owned);
    for (std::size_t i = 0; i < particles.size(); ++i) EXPECT_EQ(rates.momentum[i], sums[i]);
    return sums;
}

template<int D> bool inside(const Vec<D>& x) { return x.minCoeff() > 2.5 && x.maxCoeff() < side - 2.5; }

template<int D> void expect_laplacian(double tolerance)
{
    const auto particles = stream<D>([](double y) { return 0.05 * y * y; }, 0.0);
    const auto forces = forces_between(particles);
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (inside<D>(particles.position[i])) {
            EXPECT_NEAR(forces[i][0], mu * 0.1, tolerance * mu * 0.1);
        }
}

TEST(ViscousForce, IsTheLaplacianOnALattice)
{
    expect_laplacian<2>(0.004);
    expect_laplacian<3>(0.02);
}

TEST(ViscousForce, KeepsMomentumAndOnlyLosesEnergy)
{
    const auto particles = stream<2>([](double y) { return std::sin(y); }, 0.2);
    const auto forces = forces_between(particles);
    Vec<2> sum = Vec<2>::Zero();
    double scale = 0, power = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        sum += forces[i];
        scale += forces[i].norm();
        power += forces[i].dot(particles.velocity[i]);
    }
    EXPECT_LT(sum.norm(), 1e-13 * scale);
    EXPECT_LT(power, 0.0);
}

/// Shear along a wall at y = 0, at rest or moving with the fluid next to it: mu dv/dy on its length, or nothing.
Vec<2> drag_on_wall(bool no_slip)
{
    Walls<2> walls(sample::unit_settings<2>());
    WallBody body{"floor"};
    body.no_slip = no_slip;
    walls.add_fixed(body, {side, 0.0, 0.0, 0.0}, {{0, 1, -1, -1}});
    const auto particles = stream<2>([](double y) { return 0.5 * y; }, 0.0);
    const auto neighbours = sample::reached_neighbours(particles, 2.46);
    PairRecords<2> records;
    records.load_states(particles, Tait{1000, 30}, particles.owned);
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);
    WallImages<2> images;
    images.find(walls, records, particles, neighbours);
    WallForces<2> forces;
    forces.on_particle.assign(walls.contacts().contacts.size(), Vec<2>::Zero());
    forces.on_wall.assign(walls.contacts().planes.size(), Vec<2>::Zero());
    ViscousForce<2>(mu, plain_model<2>()).add_at_walls(forces, images, walls, records);
    Vec<2> drag = Vec<2>::Zero(), back = Vec<2>::Zero();
    for (std::size_t c = 0; c < walls.contacts().contacts.size(); ++c) {
        const WallContact& contact = walls.contacts().contacts[c];
        const double x = particles.position[static_cast<std::size_t>(contact.particle)].x();
        if (x < 3 || x > side - 3) continue; // the ends lack neighbours
        for (int p = contact.plane_begin; p < contact.plane_end; ++p)
            drag += forces.on_wall[static_cast<std::size_t>(p)];
        back += forces.on_particle[c];
    }
    EXPECT_LT((drag + back).norm(), 1e-13 * (drag.norm() + 1.0));
    return drag / (side - 6);
}

TEST(ViscousForce, DragsAWallWithoutSlip)
{
    const Vec<2> drag = drag_on_wall(true);
    EXPECT_NEAR(drag.x(), mu * 0.5, 0.01 * mu * 0.5);
    EXPECT_NEAR(drag.y(), 0.0, 1e-12);
    EXPECT_NEAR(drag_on_wall(false).x(), 0.0, 0.05 * mu * 0.5);
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/operators/wall_flux.hpp"
#include "sph_solver/operators/wall_gradients.hpp"
#include "tests/sph_solver/operators/sample_fluid.hpp"
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;

constexpr double density_at_test = 1001;

template<int D> FluidModel<D> unit_model()
{
    return {CubicSpline<D>(smoothing_length), Tait{1000, 30}, VanAlbada{}, Vec<D>::Zero()};
}

template<int D> void set_uniform(Particles<D>& particles, const Tait& eos)
{
    for (std::size_t i = 0; i < particles.size(); ++i) {
        particles.density[i] = density_at_test;
        particles.mass[i] = density_at_test * particles.volume[i];
        particles.pressure[i] = eos.pressure(density_at_test);
        particles.sound_speed[i] = eos.sound_speed(density_at_test);
    }
}

/// Forces of the walls on a fluid of constant pressure; unit of force: p dx^(D-1).
template<int D> WallForces<D> forces_on(Walls<D>& walls, Particles<D>& particles, Rates<D>& rates)
{
    const auto model = unit_model<D>();
    set_uniform(particles, model.eos);
    const auto neighbours = brute_force_neighbours(particles, walls.settings().support);
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);
    rates.reset(particles.size());
    WallForces<D> forces;
    add_fluid_wall_flux(rates, forces, walls, particles, neighbours, model);
    const double unit = model.eos.pressure(density_at_test);
    for (auto& force : forces.on_particle) force /= unit;
    for (auto& force : forces.on_wall) force /= unit;
    return forces;
}

/// Sum over facets of the force along their normals, from the fluid to the wall.
double push(const Walls<2>& walls, const WallForces<2>& forces)
{
    double sum = 0;
    for (std::size_t p = 0; p < forces.on_wall.size(); ++p)
        sum -= forces.on_wall[p].dot(walls.facets().normal(walls.contacts().planes[p].facet));
    return sum;
}

std::vector<Vec<2>> polygon(int sides, double radius, bool fluid_inside)
{
    std::vector<Vec<2>> points;
    for (int k = 0; k <= sides; ++k) points.push_back(polar(radius, (fluid_inside ? -360.0 : 360.0) * k / sides + 11));
    return points;
}

/// Fluid on a lattice finer than the kernel, inside or outside of a polygon: the wall's force is p times its length,
/// whatever the angle between its facets (10 to 120 degrees: bent sheets, a fan around a curve, corners).
void expect_exact_force(int sides, bool fluid_inside)
{
    const double radius = 5, fine = 0.25;
    const auto points = polygon(sides, radius, fluid_inside);
    auto walls = lines({points});
    const double within = radius * std::cos(std::numbers::pi / sides);
    std::vector<Vec<2>> positions;
    for (double a = -9; a < 9; a += fine)
        for (double b = -9; b < 9; b += fine) {
            const Vec<2> x(a + 0.4 * fine, b + 0.6 * fine);
            bool inside = true;
            for (std::size_t k = 0; k + 1 < points.size(); ++k) {
                const Vec<2> normal = (0.5 * (points[k] + points[k + 1])).normalized();
                inside = inside && x.dot(normal) < within;
            }
            if (inside == fluid_inside) positions.push_back(x);
        }
    auto particles = particles_at<2>(positions, fine * fine);
    Rates<2> rates;
    const auto forces = forces_on<2>(walls, particles, rates);
    const double length = 2 * sides * radius * std::sin(std::numbers::pi / sides);
    EXPECT_NEAR(push(walls, forces) / length, 1, fluid_inside ? 0.01 : 0.03)
        << sides << " sides, fluid " << (fluid_inside ? "inside" : "outside");
}

TEST(WallForce, IsPressureTimesAreaOnBentSheetsFansAndCorners)
{
    for (const int sides : {3, 4, 6, 8, 9, 12, 36}) expect_exact_force(sides, true);
}

TEST(WallForce, IsPressureTimesAreaAroundConvexBodies)
{
    for (const int sides : {4, 6, 12, 36}) expect_exact_force(sides, false);
}

template<int D> std::vector<Vec<D>> lattice(int side)
{
    std::vector<Vec<D>> positions;
    const int count = D == 2 ? side * side : side * side * side;
    for (int k = 0; k < count; ++k) {
        Vec<D> x;
        for (int d = 0, rest = k; d < D; ++d, rest /= side) x[d] = rest % side + 0.5;
        positions.push_back(x);
    }
    return positions;
}

/// Largest total force on a particle of a box full of fluid, pair forces of the fluid included.
template<int D> double largest_force(Walls<D>& walls, Particles<D>& particles)
{
    Rates<D> rates;
    const auto model = unit_model<D>();
    auto forces = forces_on(walls, particles, rates);
    std::vector<Vec<D>> total(particles.size(), Vec<D>::Zero());
    for (std::size_t c = 0; c < forces.on_particle.size(); ++c)
        total[static_cast<std::size_t>(walls.contacts().contacts[c].particle)] = forces.on_particle[c];
    for (std::size_t i = 0; i < total.size(); ++i)
        for (std::size_t j = 0; j < total.size(); ++j) {
            const Vec<D> x_ij = particles.position[j] - particles.position[i];
            if (i != j) total[i] -= 2 * model.kernel.slope(x_ij.norm()) * x_ij.normalized();
        }
    double largest = 0;
    for (const auto& force : total) largest = std::max(largest, force.norm());
    return largest;
}

TEST(WallForce, KeepsALatticeInABoxStill)
{
    auto square = lines({{Vec<2>(0, 0), Vec<2>(0, 8), Vec<2>(8, 8), Vec<2>(8, 0), Vec<2>(0, 0)}});
    auto particles = particles_at<2>(lattice<2>(8));
    EXPECT_LT(largest_force<2>(square, particles), 1e-9);
    auto box = cube(6);
    auto particles_3d = particles_at<3>(lattice<3>(6));
    EXPECT_LT(largest_force<3>(box, particles_3d), 1e-9);
}

TEST(WallForce, OfEachWallOfACubeIsPressureTimesArea)
{
    auto box = cube(6);
    auto particles = particles_at<3>(lattice<3>(6));
    Rates<3> rates;
    const auto forces = forces_on<3>(box, particles, rates);
    Vec<3> low = Vec<3>::Zero(), high = Vec<3>::Zero();
    for (std::size_t p = 0; p < forces.on_wall.size(); ++p) {
        const Vec<3>& normal = box.facets().normal(box.contacts().planes[p].facet);
        const Vec<3> force = forces.on_wall[p];
        (normal.sum() > 0 ? low : high) += force.cwiseProduct(normal.cwiseAbs());
    }
    for (int d = 0; d < 3; ++d) {
        EXPECT_NEAR(low[d], -36, 0.36);
        EXPECT_NEAR(high[d], 36, 0.36);
    }
}

TEST(WallForce, ActionIsReaction)
{
    auto square = lines({{Vec<2>(0, 0), Vec<2>(0, 8), Vec<2>(8, 8), Vec<2>(8, 0), Vec<2>(0, 0)}});
    auto particles = jittered_lattice<2>(8, 1.0, 0.2, 1000);
    for (auto& v : particles.velocity) v.setZero();
    for (auto& g : particles.density_gradient) g.setZero();
    for (auto& g : particles.velocity_gradient) g.setZero();
    Rates<2> rates;
    const auto forces = forces_on<2>(square, particles, rates);
    const auto& contacts = square.contacts().contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        Vec<2> sum = forces.on_particle[c];
        for (int p = contacts[c].plane_begin; p < contacts[c].plane_end; ++p)
            sum += forces.on_wall[static_cast<std::size_t>(p)];
        EXPECT_LT(sum.norm(), 1e-12);
    }
}

TEST(WallForce, GradientsNextToAWallAreThoseOfAFullNeighbourhood)
{
    auto walls = lines({{Vec<2>(0, 0), Vec<2>(0, 8), Vec<2>(8, 8), Vec<2>(8, 0), Vec<2>(0, 0)}});
    auto particles = particles_at<2>(lattice<2>(8));
    const auto model = unit_model<2>();
    set_uniform(particles, model.eos);
    const auto neighbours = brute_force_neighbours(particles, walls.settings().support);
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);
    GradientField<2> sums(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (const int j : neighbours.of(i)) {
            const Vec<2> x_ij = particles.position[static_cast<std::size_t>(j)] - particles.position[i];
            sums[i].moment += model.kernel.slope(x_ij.norm()) / x_ij.norm() * x_ij * x_ij.transpose();
        }
    const Mat<2> middle = sums[3 * 8 + 3].moment;
    accumulate_wall_gradients(sums, walls, particles, neighbours, model);
    for (const auto& sum : sums) {
        EXPECT_LT((sum.moment - middle).norm(), 1e-12);
        EXPECT_LT(sum.velocity.norm(), 1e-12);
        EXPECT_LT(sum.density.norm(), 1e-9);
    }
}

} // namespace
} // namespace sph

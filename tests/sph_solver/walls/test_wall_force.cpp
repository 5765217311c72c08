// SPDX-License-Identifier: MIT
#include "tests/sph_solver/support/reached_neighbours.hpp"
#include "tests/sph_solver/support/wall_pass.hpp"
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
    const auto neighbours = reached_neighbours(particles, walls.settings().support);
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);
    rates.reset(particles.size());
    WallForces<D> forces = WallPass<D>(walls, particles, neighbours, model).forces(rates);
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

/// Fluid along a polygon, in layers parallel to its sides, as cells finer than the kernel whose volumes fill space
/// exactly.
Particles<2> layers_along(const std::vector<Vec<2>>& points, double apothem, bool fluid_inside)
{
    const double fine = 0.2;
    std::vector<Vec<2>> positions;
    std::vector<double> volumes;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const double length = (points[k + 1] - points[k]).norm();
        for (int layer = 0; layer < 26; ++layer) {
            const double scale = 1 + (fluid_inside ? -1 : 1) * (layer + 0.5) * fine / apothem;
            const int cells = static_cast<int>(std::ceil(scale * length / fine));
            for (int c = 0; c < cells && scale > 0; ++c) {
                positions.push_back(scale * (points[k] + (c + 0.5) / cells * (points[k + 1] - points[k])));
                volumes.push_back(fine * scale * length / cells);
            }
        }
    }
    auto particles = particles_at<2>(positions);
    particles.volume = volumes;
    return particles;
}

/// Force of a fluid at constant pressure on a polygon over p times its length.
double force_ratio(int sides, bool fluid_inside, double radius)
{
    const auto points = polygon(sides, radius, fluid_inside);
    auto walls = lines({points});
    auto particles = layers_along(points, radius * std::cos(std::numbers::pi / sides), fluid_inside);
    Rates<2> rates;
    const auto forces = forces_on<2>(walls, particles, rates);
    return push(walls, forces) / (2 * sides * radius * std::sin(std::numbers::pi / sides));
}

TEST(WallForce, IsPressureTimesAreaOnBentSheetsAndCorners)
{
    for (const int sides : {4, 6, 8, 9}) EXPECT_NEAR(force_ratio(sides, true, 12), 1, 0.01) << sides << " sides";
}

/// Force of a fluid at constant pressure on one half of a polygon with 4, 8 ... sides, across the cut, over p times its width.
double half_force_ratio(int sides, double radius)
{
    const auto points = polygon(sides, radius, false);
    auto walls = lines({points});
    const double apothem = radius * std::cos(std::numbers::pi / sides);
    auto particles = layers_along(points, apothem, false);
    Rates<2> rates;
    const auto forces = forces_on<2>(walls, particles, rates);
    const Vec<2> axis = polar(1, 11 + 180.0 / sides);
    double sum = 0;
    for (std::size_t c = 0; c < forces.on_particle.size(); ++c) {
        const auto i = static_cast<std::size_t>(walls.contacts().contacts[c].particle);
        if (particles.position[i].dot(axis) > 0) sum += forces.on_particle[c].dot(axis);
    }
    return sum / (2 * apothem);
}

// Water transmits a third of a spacing's width of pressure less beside a wall, because pairs across the wall are missing
// there: by docs/theory/walls.md delta = 2 int W r^2 dr = 0.333 dx on each side of a cut. The wall bears it instead.
constexpr double delta = 0.333;

TEST(WallForce, OnAConvexBodyIsThatOfABodyOneThirdOfASpacingWider)
{
    for (const int sides : {4, 8, 72})
        EXPECT_NEAR(half_force_ratio(sides, 12), 1 + delta / 12, 0.01) << sides << " sides";
    EXPECT_NEAR(half_force_ratio(72, 8), 1 + delta / 8, 0.01);
    EXPECT_NEAR(force_ratio(72, false, 12), 1 + delta / 12, 0.005); // and so it is spread over the circle
    EXPECT_NEAR(force_ratio(72, true, 12), 1 - delta / 12, 0.005);
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
    auto box = cube_walls(6);
    auto particles_3d = particles_at<3>(lattice<3>(6));
    EXPECT_LT(largest_force<3>(box, particles_3d), 1e-9);
}

TEST(WallForce, OfEachWallOfACubeIsPressureTimesArea)
{
    auto box = cube_walls(6);
    auto particles = particles_at<3>(lattice<3>(6));
    Rates<3> rates;
    const auto forces = forces_on<3>(box, particles, rates);
    Vec<3> low = Vec<3>::Zero(), high = Vec<3>::Zero();
    for (std::size_t p = 0; p < forces.on_wall.size(); ++p) {
        const Vec<3>& normal = box.facets().normal(box.contacts().planes[p].facet);
        (normal.sum() > 0 ? low : high) += forces.on_wall[p].cwiseProduct(normal.cwiseAbs());
    }
    // p A times the moment sum w x |W'| x/r of the bare lattice, which is 0.98 instead of 1 in 3D at h = 1.23 dx
    double moment = 0;
    const CubicSpline<3> kernel(smoothing_length);
    for (int a = -3; a <= 3; ++a)
        for (int b = -3; b <= 3; ++b)
            for (int c = -3; c <= 3; ++c) {
                const double r = std::sqrt(a * a + b * b + c * c);
                if (r > 0) moment += kernel.slope(r) / r * a * a;
            }
    for (int d = 0; d < 3; ++d) {
        EXPECT_NEAR(low[d], -36 * moment, 0.01 * 36);
        EXPECT_NEAR(high[d], 36 * moment, 0.01 * 36);
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
    const auto neighbours = reached_neighbours(particles, walls.settings().support);
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);
    GradientField<2> sums(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (const int j : neighbours.of(i)) {
            const Vec<2> x_ij = particles.position[static_cast<std::size_t>(j)] - particles.position[i];
            sums[i].moment += model.kernel.slope(x_ij.norm()) / x_ij.norm() * x_ij * x_ij.transpose();
        }
    const Mat<2> middle = sums[3 * 8 + 3].moment;
    WallPass<2>(walls, particles, neighbours, model).add_gradients(sums);
    for (const auto& sum : sums) {
        EXPECT_LT((sum.moment - middle).norm(), 1e-12);
        EXPECT_LT(sum.velocity.norm(), 1e-12);
        EXPECT_LT(sum.density.norm(), 1e-9);
    }
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/numerics/pair_flux.hpp"
#include "tests/sph_solver/support/reached_neighbours.hpp"
#include "tests/sph_solver/support/wall_pass.hpp"
#include "tests/sph_solver/walls/wall_samples.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using namespace sample;

template<int D> FluidModel<D> heavy_model()
{
    return {CubicSpline<D>(smoothing_length), Tait{1000, 30}, VanAlbada{}, Vec<D>::Constant(-4)};
}

/// Noise in every field of a lattice; unit spacing.
template<int D> Particles<D> noisy_fluid(int side, const Tait& eos)
{
    auto particles = jittered_lattice<D>(side, 1.0, 0.2, eos.rho0);
    Noise noise(3);
    for (std::size_t i = 0; i < particles.size(); ++i) {
        particles.density[i] = eos.rho0 * (1 + 0.01 * noise());
        particles.sound_speed[i] = eos.sound_speed(particles.density[i]);
        particles.volume[i] *= 1 + 0.1 * noise();
        for (int a = 0; a < D; ++a) {
            particles.velocity[i][a] = 3 * noise();
            particles.density_gradient[i][a] = 5 * noise();
            for (int b = 0; b < D; ++b) particles.velocity_gradient[i](a, b) = 2 * noise();
        }
    }
    return particles;
}

/// Both passes with one image at a time.
template<int D> struct Plain {
    GradientField<D> sums;
    std::vector<Vec<D>> force;

    Plain(const Walls<D>& walls, const Particles<D>& particles, const ReachedNeighbours& neighbours,
          const FluidModel<D>& model)
        : sums(particles.size())
    {
        const auto state_of = [&](std::size_t i) {
            return PrimitiveState<D>{particles.density[i], particles.velocity[i], particles.density_gradient[i],
                                     particles.velocity_gradient[i]};
        };
        auto calm_planes = walls.contacts().planes; // volumes do not feel the push
        for (auto& plane : calm_planes) plane.push = 0;
        const auto image_state = [&](const Image<D>& image) {
            const auto j = static_cast<std::size_t>(image.source);
            PrimitiveState<D> state = state_of(j);
            mirror_state(state, image, particles.sound_speed[j], walls.settings());
            return state;
        };
        const auto weighted_path = [&](const Image<D>& image) -> Vec<D> {
            const double r = std::sqrt(image.squared_distance);
            const double volume = particles.volume[static_cast<std::size_t>(image.source)];
            return (image.weight * volume * model.kernel.slope(r) / r) * image.x_ij;
        };
        const ImageFinder<D> finder(walls.settings());
        for (const WallContact& contact : walls.contacts().contacts) {
            const auto i = static_cast<std::size_t>(contact.particle);
            Vec<D> total = Vec<D>::Zero();
            const auto add_gradients = [&](const Image<D>& image) {
                const PrimitiveState<D> state = image_state(image);
                const Vec<D> weighted = weighted_path(image);
                sums[contact.row].moment += image.x_ij * weighted.transpose();
                sums[contact.row].velocity += (state.velocity - particles.velocity[i]) * weighted.transpose();
                sums[contact.row].density += (state.density - particles.density[i]) * weighted;
            };
            const auto add_force = [&](const Image<D>& image) {
                const PrimitiveState<D> state = image_state(image);
                const double p = pair_flux(state_of(i), state, image.x_ij, model.eos, VanAlbada{}, true).pressure;
                total -= 2 * particles.volume[i] * p * weighted_path(image);
            };
            const auto row = neighbours.of(contact.row);
            finder.for_each(contact, calm_planes, particles.position, row, add_gradients);
            finder.for_each(contact, walls.contacts().planes, particles.position, row, add_force);
            force.push_back(total);
        }
    }
};

/// Largest differences between packs and plain numbers, as parts of the sizes at hand.
template<int D> void expect_same_as_plain(Walls<D>& walls, const Particles<D>& particles)
{
    const auto model = heavy_model<D>();
    const auto neighbours = reached_neighbours(particles, walls.settings().support);
    walls.prepare(particles, 0.1);
    walls.find_contacts(particles);
    const WallPass<D> packs(walls, particles, neighbours, model);
    const Plain<D> plain(walls, particles, neighbours, model);
    GradientField<D> sums(particles.size());
    packs.add_gradients(sums);
    Rates<D> rates;
    rates.reset(particles.size());
    const auto forces = packs.forces(rates);
    ASSERT_GT(plain.force.size(), particles.size() / 2);
    for (std::size_t k = 0; k < sums.size(); ++k) {
        EXPECT_LT((sums[k].moment - plain.sums[k].moment).norm(), 1e-12);
        EXPECT_LT((sums[k].velocity - plain.sums[k].velocity).norm(), 1e-11);
        EXPECT_LT((sums[k].density - plain.sums[k].density).norm(), 1e-9);
    }
    for (std::size_t c = 0; c < plain.force.size(); ++c) {
        const WallContact& contact = walls.contacts().contacts[c];
        const double volume = particles.volume[static_cast<std::size_t>(contact.particle)];
        EXPECT_LT((forces.on_particle[c] - plain.force[c]).norm(), 1e-11 * model.eos.stiffness()) << "contact " << c;
        EXPECT_NEAR(forces.dilation[c], volume * plain.sums[contact.row].velocity.trace(), 1e-11) << "contact " << c;
    }
}

template<int D> WallSettings<D> heavy_settings()
{
    auto settings = unit_settings<D>();
    settings.gravity = Vec<D>::Constant(-4);
    settings.push_from = 0.5;
    settings.push_rate = 3;
    return settings;
}

RigidMotion<2> shake()
{
    RigidMotion<2> motion;
    motion.translation[0] = [](double t) { return base::TimeValue{0.1 * t, 0.7, 11.0}; };
    return motion;
}

TEST(ImagePacks, AreThePlainImagesInACornerOfAMovingAndAStickyWall)
{
    Walls<2> walls(heavy_settings<2>());
    walls.add_fixed({"sticky floor", true}, {9, 0, -1, 0}, {{0, 1, -1, -1}});
    walls.add_fixed({"slope"}, {6, 6, 12, 1}, {{0, 1, -1, -1}}); // oblique, with two free ends
    walls.add_driven({"piston"}, {0, 0, 0, 9}, {{0, 1, -1, -1}}, shake());
    const auto particles = noisy_fluid<2>(6, heavy_model<2>().eos);
    expect_same_as_plain<2>(walls, particles);
}

TEST(ImagePacks, AreThePlainImagesInABoxIn3D)
{
    Walls<3> walls(heavy_settings<3>());
    std::vector<double> corners;
    for (int v = 0; v < 8; ++v)
        for (int d = 0; d < 3; ++d) corners.push_back((v >> d & 1) != 0 ? 5.0 : 0.0);
    walls.add_fixed({"box"}, corners,
                    {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}});
    expect_same_as_plain<3>(walls, noisy_fluid<3>(5, heavy_model<3>().eos));
}

TEST(ImagePacks, GroupsAreWholePacksThatBeginWithTheOwnImage)
{
    auto square = lines({{Vec<2>(0, 0), Vec<2>(0, 8), Vec<2>(8, 8), Vec<2>(8, 0), Vec<2>(0, 0)}});
    const auto particles = noisy_fluid<2>(8, Tait{1000, 30});
    const auto neighbours = reached_neighbours(particles, square.settings().support);
    square.prepare(particles, 0.1);
    square.find_contacts(particles);
    const auto model = heavy_model<2>();
    const WallPass<2> pass(square, particles, neighbours, model);
    for (const ImageGroup& group : pass.images.groups()) {
        EXPECT_EQ((group.end - group.begin) % row_unit, 0u);
        const int self = square.contacts().contacts[group.contact].particle;
        EXPECT_EQ(group.own_first,
                  pass.images.sources()[group.begin] == self && *pass.images.weights(group, group.begin) > 0);
        for (std::size_t n = group.begin + 1; n < group.end; ++n)
            EXPECT_EQ(pass.images.sources()[n] == self, *pass.images.weights(group, n) == 0)
                << "only fillings are itself";
    }
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/operators/wall_flux.hpp"

#include "sph_solver/walls/images.hpp"

#include <cmath>
#include <Eigen/LU>

namespace sph {
namespace {

template<int D> PrimitiveState<D> primitive_state(const Particles<D>& particles, std::size_t i)
{
    return {particles.density[i], particles.velocity[i], particles.density_gradient[i], particles.velocity_gradient[i]};
}

/// Gives a force to the walls of an image: its components along their normals where these are far from parallel, else
/// all to the last.
template<int D>
void share_out(const Vec<D>& force, const Image<D>& image, const MirrorPlane<D>* first, std::vector<Vec<D>>& on_wall,
               std::size_t begin)
{
    const auto of = [&](int k) -> Vec<D>& {
        return on_wall[begin + static_cast<std::size_t>(image.path[static_cast<std::size_t>(k)] - first)];
    };
    const auto normal = [&](int k) -> const Vec<D>& { return image.path[static_cast<std::size_t>(k)]->normal; };
    const int last = image.order - 1;
    Vec<D> rest = force;
    if (image.order == 2 && std::abs(normal(0).dot(normal(1))) < 0.7) {
        const double cosine = normal(0).dot(normal(1));
        const double a = force.dot(normal(0)), b = force.dot(normal(1));
        const Vec<D> part = ((a - cosine * b) / (1 - cosine * cosine)) * normal(0);
        of(0) += part;
        rest -= part;
    } else if (D == 3 && image.order == 3 && image.path[0] != image.path[2]) {
        Mat<D> normals;
        for (int k = 0; k < D; ++k) normals.col(k) = normal(k);
        if (std::abs(normals.determinant()) > 0.3) {
            const Vec<D> share = normals.inverse() * force;
            for (int k = 0; k < last; ++k) {
                of(k) += share[k] * normal(k);
                rest -= share[k] * normal(k);
            }
        }
    }
    of(last) += rest;
}

template<int D, class AnyLimiter>
void sum_forces(WallForces<D>& forces, const Walls<D>& walls, const Particles<D>& particles,
                const NeighbourList& neighbours, const FluidModel<D>& model, AnyLimiter limiter)
{
    const ImageFinder<D> finder(walls.settings());
    const auto& planes = walls.contacts().planes;
    for (std::size_t c = 0; c < walls.contacts().contacts.size(); ++c) {
        const WallContact& contact = walls.contacts().contacts[c];
        const auto i = static_cast<std::size_t>(contact.particle);
        const auto begin = static_cast<std::size_t>(contact.plane_begin);
        const PrimitiveState<D> mine = primitive_state(particles, i);
        finder.for_each(contact, planes, particles.position, neighbours.of(contact.row), [&](const Image<D>& image) {
            const auto j = static_cast<std::size_t>(image.source);
            PrimitiveState<D> state = primitive_state(particles, j);
            mirror_state(state, image, particles.sound_speed[j], walls.settings());
            const double pressure = pair_flux(mine, state, image.x_ij, model.eos, limiter, true).pressure;
            const double r = std::sqrt(image.squared_distance);
            const double area = 2 * particles.volume[i] * image.weight * particles.volume[j] * model.kernel.slope(r);
            const Vec<D> force = (area * pressure / r) * image.x_ij;
            forces.on_particle[c] -= force;
            share_out(force, image, &planes[begin], forces.on_wall, begin);
        });
    }
}

} // namespace

template<int D>
void add_fluid_wall_flux(Rates<D>& rates, WallForces<D>& forces, const Walls<D>& walls, const Particles<D>& particles,
                         const NeighbourList& neighbours, const FluidModel<D>& model)
{
    const auto& contacts = walls.contacts().contacts;
    forces.on_particle.assign(contacts.size(), Vec<D>::Zero());
    forces.on_wall.assign(walls.contacts().planes.size(), Vec<D>::Zero());
    std::visit([&](auto limiter) { sum_forces(forces, walls, particles, neighbours, model, limiter); }, model.limiter);
    for (std::size_t c = 0; c < contacts.size(); ++c)
        rates.momentum[static_cast<std::size_t>(contacts[c].particle)] += forces.on_particle[c];
}

template<int D>
void add_wall_power(WallPower& power, double weight, const WallForces<D>& forces, const Walls<D>& walls,
                    const Particles<D>& particles, const GradientField<D>& sums)
{
    const auto& planes = walls.contacts().planes;
    for (std::size_t c = 0; c < walls.contacts().contacts.size(); ++c) {
        const WallContact& contact = walls.contacts().contacts[c];
        const auto i = static_cast<std::size_t>(contact.particle);
        double work = 0;
        for (auto p = static_cast<std::size_t>(contact.plane_begin); p < static_cast<std::size_t>(contact.plane_end);
             ++p) {
            const double part = -forces.on_wall[p].dot(planes[p].velocity);
            (walls.facets().is_wet(planes[p].facet) ? power.by_interface : power.by_walls).add(weight * part);
            work += part;
        }
        const GradientSums<D>& sum = sums[contact.row];
        const double volume_rate = particles.volume[i] * (sum.divergence() - sum.fluid_divergence);
        const double gain = particles.velocity[i].dot(forces.on_particle[c]) - particles.pressure[i] * volume_rate;
        power.dissipation.add(weight * (work - gain));
    }
}

template void add_fluid_wall_flux<2>(Rates<2>&, WallForces<2>&, const Walls<2>&, const Particles<2>&,
                                     const NeighbourList&, const FluidModel<2>&);
template void add_fluid_wall_flux<3>(Rates<3>&, WallForces<3>&, const Walls<3>&, const Particles<3>&,
                                     const NeighbourList&, const FluidModel<3>&);
template void add_wall_power<2>(WallPower&, double, const WallForces<2>&, const Walls<2>&, const Particles<2>&,
                                const GradientField<2>&);
template void add_wall_power<3>(WallPower&, double, const WallForces<3>&, const Walls<3>&, const Particles<3>&,
                                const GradientField<3>&);

} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/operators/wall_gradients.hpp"

#include "sph_solver/walls/images.hpp"

#include <cmath>

namespace sph {

template<int D>
void accumulate_wall_gradients(GradientField<D>& sums, const Walls<D>& walls, const Particles<D>& particles,
                               const NeighbourList& neighbours, const FluidModel<D>& model)
{
    const ImageFinder<D> finder(walls.settings());
    for (const WallContact& contact : walls.contacts().contacts) {
        const auto i = static_cast<std::size_t>(contact.particle);
        const Vec<D> v_i = particles.velocity[i];
        const double rho_i = particles.density[i];
        GradientSums<D>& sum = sums[contact.row];
        finder.for_each(contact, walls.contacts().planes, particles.position, neighbours.of(contact.row),
                        [&](const Image<D>& image) {
                            const auto j = static_cast<std::size_t>(image.source);
                            Vec<D> velocity = particles.velocity[j];
                            double density = particles.density[j];
                            mirror_values(velocity, density, image, particles.sound_speed[j], walls.settings());
                            const double r = std::sqrt(image.squared_distance);
                            const Vec<D> weighted =
                                (image.weight * particles.volume[j] * model.kernel.slope(r) / r) * image.x_ij;
                            sum.moment += image.x_ij * weighted.transpose();
                            sum.velocity += (velocity - v_i) * weighted.transpose();
                            sum.density += (density - rho_i) * weighted;
                        });
    }
}

template void accumulate_wall_gradients<2>(GradientField<2>&, const Walls<2>&, const Particles<2>&,
                                           const NeighbourList&, const FluidModel<2>&);
template void accumulate_wall_gradients<3>(GradientField<3>&, const Walls<3>&, const Particles<3>&,
                                           const NeighbourList&, const FluidModel<3>&);

} // namespace sph

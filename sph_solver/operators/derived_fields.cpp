// SPDX-License-Identifier: MIT
#include "sph_solver/operators/derived_fields.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace sph {
namespace {

template<int D> void refuse(const Particles<D>& particles, std::size_t i)
{
    throw base::Error(base::ExitCode::numerical_failure,
                      base::text("particle ", particles.id[i], " at (", particles.position[i].transpose(),
                                 ") m has mass ", particles.mass[i], ", volume ", particles.volume[i], ", momentum (",
                                 particles.momentum[i].transpose(),
                                 "): the fluid has diverged; a smaller time.cfl or a finer start may help"));
}

template<int D> void derive(Particles<D>& particles, const Tait& eos, std::size_t i)
{
    const double mass = particles.mass[i];
    const double density = mass / particles.volume[i];
    particles.velocity[i] = particles.momentum[i] / mass;
    particles.density[i] = density;
    particles.pressure[i] = eos.pressure(density);
    particles.sound_speed[i] = eos.sound_speed(density);
    const double energy = particles.velocity[i].squaredNorm();
    if (!(mass > 0.0 && density > 0.0 && energy < 1e300)) refuse(particles, i);
}

} // namespace

template<int D> void update_derived(Particles<D>& particles, const Tait& eos)
{
    for (std::size_t i = 0; i < particles.size(); ++i) derive(particles, eos, i);
}

template<int D> void update_derived(Particles<D>& particles, const Tait& eos, const std::vector<int>& which)
{
    for (const int i : which) derive(particles, eos, static_cast<std::size_t>(i));
}

template void update_derived<2>(Particles<2>&, const Tait&, const std::vector<int>&);
template void update_derived<3>(Particles<3>&, const Tait&, const std::vector<int>&);
template void update_derived<2>(Particles<2>&, const Tait&);
template void update_derived<3>(Particles<3>&, const Tait&);

} // namespace sph

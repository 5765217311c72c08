// SPDX-License-Identifier: MIT
#include "sph_solver/state/outflow.hpp"

#include "sph_solver/state/canonical_order.hpp"

namespace sph {

template<int D> void Outflow<D>::remove(Particles<D>& particles)
{
    if (planes_.empty()) return;
    drop_halo(particles);
    std::vector<std::uint8_t> stays(particles.size(), 1);
    bool any = false;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (!is_out(particles.position[i])) continue;
        stays[i] = 0;
        any = true;
        count(particles, i);
    }
    if (any) keep_particles(particles, stays);
}

template<int D> bool Outflow<D>::is_out(const Vec<D>& x) const
{
    for (const OutflowPlane<D>& plane : planes_) {
        if ((x - plane.point).dot(plane.normal) > 0.0) return true;
    }
    return false;
}

template<int D> void Outflow<D>::count(const Particles<D>& particles, std::size_t i)
{
    const double mass = particles.mass[i];
    const Vec<D>& momentum = particles.momentum[i];
    ++totals_.particles;
    totals_.mass.add(mass);
    for (int d = 0; d < D; ++d) totals_.momentum[static_cast<std::size_t>(d)].add(momentum[d]);
    totals_.kinetic.add(0.5 * momentum.squaredNorm() / mass);
    totals_.potential.add(-mass * gravity_.dot(particles.position[i]));
    totals_.internal.add(mass * eos_.specific_internal_energy(mass / particles.volume[i]));
}

template class Outflow<2>;
template class Outflow<3>;

} // namespace sph

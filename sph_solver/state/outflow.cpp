// SPDX-License-Identifier: MIT
#include "sph_solver/state/outflow.hpp"

#include "sph_solver/state/canonical_order.hpp"

namespace sph {

template<int D> void Outflow<D>::remove(Particles<D>& particles, const std::vector<std::uint8_t>& trapped)
{
    if (planes_.empty() && trapped.empty()) return;
    drop_halo(particles);
    std::vector<std::uint8_t> stays(particles.size(), 1);
    bool any = false;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const bool is_trapped = !trapped.empty() && trapped[i] != 0;
        if (!is_trapped && !is_out(particles.position[i])) continue;
        stays[i] = 0;
        any = true;
        count(totals_, particles, i);
        if (is_trapped) count(trapped_, particles, i);
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

template<int D> void Outflow<D>::count(OutflowTotals& totals, const Particles<D>& particles, std::size_t i) const
{
    const double mass = particles.mass[i];
    const Vec<D>& momentum = particles.momentum[i];
    ++totals.particles;
    totals.mass.add(mass);
    for (int d = 0; d < D; ++d) totals.momentum[static_cast<std::size_t>(d)].add(momentum[d]);
    totals.kinetic.add(0.5 * momentum.squaredNorm() / mass);
    totals.potential.add(-mass * gravity_.dot(particles.position[i]));
    totals.internal.add(mass * eos_.specific_internal_energy(mass / particles.volume[i]));
}

template class Outflow<2>;
template class Outflow<3>;

} // namespace sph

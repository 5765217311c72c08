// SPDX-License-Identifier: MIT
#include "sph_solver/time/energy_ledger.hpp"

namespace sph {
namespace {

/// Places of the sums that travel in one message.
enum Place : std::size_t {
    kinetic,
    potential,
    internal,
    mass,
    momentum,
    by_walls = momentum + 3,
    by_interface,
    riemann,
    mass_flux,
    at_walls,
    viscous,
    out_mass,
    out_momentum,
    out_energy = out_momentum + 3,
    of_walls,
    of_interface = of_walls + 3,
    trapped_particles = of_interface + 3,
    trapped_mass,
    trapped_energy,
    count
};

} // namespace

template<int D>
void EnergyLedger<D>::observe(const Particles<D>& particles, const Walls<D>& walls, const Evaluation<D>& evaluation,
                              double weight, double dt)
{
    const double share = weight * dt;
    for (std::size_t k = 0; k < particles.owned.size(); ++k) {
        const auto i = static_cast<std::size_t>(particles.owned[k]);
        const FluxSums<D>& flux = evaluation.fluxes[k];
        const Vec<D>& v = particles.velocity[i];
        const double p = particles.pressure[i];
        const double carried = model_.eos.specific_enthalpy(particles.density[i]) - 0.5 * v.squaredNorm() -
                               model_.gravity.dot(particles.position[i]);
        riemann_.add(share * (p * flux.dilation - v.dot(flux.by_pressure)));
        mass_flux_.add(share * (p * flux.swept - v.dot(flux.by_mass) - carried * flux.mass +
                                particles.mass[i] * model_.gravity.dot(particles.shift[i])));
    }
    for (std::size_t k = 0; k < evaluation.viscous.size(); ++k)
        viscous_.add(-share *
                     particles.velocity[static_cast<std::size_t>(particles.owned[k])].dot(evaluation.viscous[k]));
    add_wall_power(walls_, share, evaluation.wall_forces, walls, particles);
}

template<int D>
void EnergyLedger<D>::add_energies(std::vector<base::ReproducibleSum>& sums, const Particles<D>& particles) const
{
    for (const int owned : particles.owned) {
        const auto i = static_cast<std::size_t>(owned);
        const double m = particles.mass[i];
        sums[kinetic].add(0.5 * particles.momentum[i].dot(particles.velocity[i]));
        sums[potential].add(-m * model_.gravity.dot(particles.position[i]));
        sums[internal].add(m * model_.eos.specific_internal_energy(particles.density[i]));
        sums[mass].add(m);
        for (int a = 0; a < D; ++a) sums[momentum + static_cast<std::size_t>(a)].add(particles.momentum[i][a]);
    }
}

template<int D>
EnergyBalance EnergyLedger<D>::balance(const Particles<D>& particles, const Outflow<D>& outflow,
                                       const base::Communicator& comm)
{
    std::vector<base::ReproducibleSum> sums(count);
    add_energies(sums, particles);
    sums[by_walls] = walls_.by_walls;
    sums[by_interface] = walls_.by_interface;
    sums[riemann] = riemann_;
    sums[mass_flux] = mass_flux_;
    sums[at_walls] = walls_.dissipation;
    sums[viscous] = viscous_;
    const OutflowTotals& out = outflow.totals();
    sums[out_mass] = out.mass;
    for (std::size_t a = 0; a < 3; ++a) sums[out_momentum + a] = out.momentum[a];
    for (const auto& part : {out.kinetic, out.potential, out.internal}) sums[out_energy] += part;
    for (std::size_t a = 0; a < 3; ++a) {
        sums[of_walls + a] = walls_.force_of_walls[a];
        sums[of_interface + a] = walls_.force_of_interface[a];
    }
    const OutflowTotals& held = outflow.trapped();
    sums[trapped_particles].add(static_cast<double>(held.particles));
    sums[trapped_mass] = held.mass;
    for (const auto& part : {held.kinetic, held.potential, held.internal}) sums[trapped_energy] += part;

    const auto all = comm.total(sums);
    const auto at = [&](std::size_t place) { return all[place].value(); };
    EnergyBalance e;
    e.kinetic = at(kinetic);
    e.potential = at(potential);
    e.internal = at(internal);
    e.total = e.kinetic + e.potential + e.internal;
    e.mass = at(mass);
    e.momentum = {at(momentum), at(momentum + 1), at(momentum + 2)};
    e.work_by_walls = at(by_walls);
    e.work_by_interface = at(by_interface);
    e.outflow_mass = at(out_mass);
    e.outflow_momentum = {at(out_momentum), at(out_momentum + 1), at(out_momentum + 2)};
    e.outflow_energy = at(out_energy);
    for (std::size_t a = 0; a < 3; ++a) {
        e.impulse_of_walls[a] = at(of_walls + a);
        e.impulse_of_interface[a] = at(of_interface + a);
    }
    e.trapped_particles = at(trapped_particles);
    e.trapped_mass = at(trapped_mass);
    e.trapped_energy = at(trapped_energy);
    e.dissipation_riemann = at(riemann);
    e.dissipation_mass_flux = at(mass_flux);
    e.dissipation_walls = at(at_walls);
    e.viscous = at(viscous);
    if (!started_) start_total_ = e.total + e.outflow_energy;
    started_ = true;
    e.balance_error = e.total - start_total_ + e.outflow_energy + e.dissipation_riemann + e.dissipation_mass_flux +
                      e.dissipation_walls + e.viscous - e.work_by_walls - e.work_by_interface;
    return e;
}

template class EnergyLedger<2>;
template class EnergyLedger<3>;

} // namespace sph

// SPDX-License-Identifier: MIT
#include "fem_solver/time/energy_ledger.hpp"

#include <numeric>

namespace fem {

void EnergyLedger::start(const Motion& motion, const Forces& forces)
{
    energies_ = {};
    energies_.kinetic = forces_->kinetic_energy(motion);
    energies_.strain = forces_->strain_energy(motion);
    energies_.potential = forces_->potential_energy(motion);
    initial_total_ = energies_.total();
    initial_material_ = forces_->lost_energy();
    energies_.work_of_load.assign(forces.each_load.size(), 0.0);
    energies_.work_of_support.assign(supports_->groups().size(), 0.0);
    weighted_ = forces;
    reaction_ = support_force(motion, weighted_);
}

void EnergyLedger::account(const Motion& motion_n, const Motion& motion_np1, const Forces& forces_n,
                           const Forces& forces_np1, double dt)
{
    const DofMap& map = forces_->map();
    const double alpha = hht_.alpha(), gamma = hht_.gamma();
    const Eigen::VectorXd du = motion_np1.displacement - motion_n.displacement;
    const Forces weighted_np1 = forces_np1.blend(1 + alpha, forces_n, -alpha);
    const Eigen::VectorXd reaction_np1 = support_force(motion_np1, weighted_np1);
    const auto work = [&](const Eigen::VectorXd& f_n, const Eigen::VectorXd& f_np1) {
        return map.dot(du, (1 - gamma) * f_n + gamma * f_np1);
    };
    const double correction = work(weighted_.correction, weighted_np1.correction);
    energies_.work_correction += correction;
    energies_.work_interface += work(weighted_.interface, weighted_np1.interface) + correction;
    energies_.work_loads += work(weighted_.loads, weighted_np1.loads);
    for (std::size_t k = 0; k < weighted_.each_load.size(); ++k)
        energies_.work_of_load[k] += work(weighted_.each_load[k], weighted_np1.each_load[k]);
    if (supports_->moves()) {
        const std::vector<double> works = supports_->sums(
            du.cwiseProduct((1 - gamma) * reaction_ + gamma * reaction_np1) + imposed_work(motion_n, motion_np1, dt));
        for (std::size_t k = 0; k < works.size(); ++k) energies_.work_of_support[k] += works[k];
        energies_.work_supports += std::accumulate(works.begin(), works.end(), 0.0);
    }
    energies_.contact += work(weighted_.contact, weighted_np1.contact);
    energies_.friction -= work(weighted_.friction, weighted_np1.friction);
    energies_.damping += work(weighted_.damping, weighted_np1.damping);

    const double strain = forces_->strain_energy(motion_np1), material = forces_->lost_energy() - initial_material_;
    const Eigen::VectorXd da = motion_np1.acceleration - motion_n.acceleration;
    const Eigen::VectorXd inertia_da = forces_->inertia(da);
    const double growth = 0.5 * map.dot(inertia_da, motion_np1.acceleration + motion_n.acceleration); // d(1/2 a.M a)
    energies_.numerical_dissipation +=
        work(weighted_.internal, weighted_np1.internal) - (strain - energies_.strain) -
        (material - energies_.material) +
        dt * dt * (hht_.beta() - 0.5 * gamma) * (growth + (gamma - 0.5) * map.dot(da, inertia_da));

    energies_.kinetic = forces_->kinetic_energy(motion_np1);
    energies_.strain = strain;
    energies_.material = material;
    energies_.potential = forces_->potential_energy(motion_np1);
    energies_.balance_error = energies_.total() - initial_total_ + energies_.damping + energies_.friction +
                              energies_.material + energies_.numerical_dissipation - energies_.contact -
                              energies_.work_interface - energies_.work_supports - energies_.work_loads;
    weighted_ = weighted_np1;
    reaction_ = reaction_np1;
}

/// The part of the moved supports' work that their own velocities and accelerations bring, entry by entry.
Eigen::VectorXd EnergyLedger::imposed_work(const Motion& motion_n, const Motion& motion_np1, double dt) const
{
    const double beta = hht_.beta(), gamma = hht_.gamma();
    const Eigen::VectorXd mean = (1 - gamma) * motion_n.acceleration + gamma * motion_np1.acceleration;
    const Eigen::VectorXd dv = motion_np1.velocity - motion_n.velocity - dt * mean;
    const Eigen::VectorXd du = motion_np1.displacement - motion_n.displacement - dt * motion_n.velocity -
                               dt * dt * ((0.5 - beta) * motion_n.acceleration + beta * motion_np1.acceleration);
    return (0.5 * dt * dv - du).cwiseProduct(forces_->inertia(mean)) +
           0.5 * dv.cwiseProduct(forces_->inertia(motion_n.velocity + motion_np1.velocity));
}

Eigen::VectorXd EnergyLedger::support_force(const Motion& motion, const Forces& weighted) const
{
    return supports_->held_part(forces_->inertia(motion.acceleration) + weighted.unbalanced());
}

} // namespace fem

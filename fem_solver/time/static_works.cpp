// SPDX-License-Identifier: MIT
#include "fem_solver/time/static_works.hpp"

#include <numeric>

namespace fem {

void StaticWorks::start(const Motion& motion, const Forces& now)
{
    energies_ = {};
    energies_.strain = first_strain_ = forces_->strain_energy(motion);
    energies_.potential = forces_->potential_energy(motion);
    energies_.work_of_load.assign(now.each_load.size(), 0.0);
    energies_.work_of_support.assign(supports_->groups().size(), 0.0);
    gravity_ = 0;
    displacement_ = motion.displacement;
    last_ = now;
}

void StaticWorks::account(const Motion& motion, const Forces& now)
{
    const Eigen::VectorXd du = motion.displacement - displacement_;
    const auto work = [&](const Eigen::VectorXd& f_0, const Eigen::VectorXd& f_1) {
        return 0.5 * forces_->map().dot(du, f_0 + f_1);
    };
    for (std::size_t k = 0; k < now.each_load.size(); ++k)
        energies_.work_of_load[k] += work(last_.each_load[k], now.each_load[k]);
    const std::vector<double> supports = supports_->sums(0.5 * du.cwiseProduct(reaction(last_) + reaction(now)));
    for (std::size_t k = 0; k < supports.size(); ++k) energies_.work_of_support[k] += supports[k];
    gravity_ += work(last_.gravity, now.gravity);
    energies_.contact += work(last_.contact, now.contact);
    energies_.friction -= work(last_.friction, now.friction);

    const auto sum = [](const std::vector<double>& works) { return std::accumulate(works.begin(), works.end(), 0.0); };
    energies_.work_loads = sum(energies_.work_of_load);
    energies_.work_supports = sum(energies_.work_of_support);
    energies_.strain = forces_->strain_energy(motion);
    energies_.material = forces_->lost_energy();
    energies_.potential = forces_->potential_energy(motion);
    energies_.balance_error = energies_.strain - first_strain_ + energies_.material + energies_.friction -
                              energies_.work_loads - energies_.work_supports - energies_.contact - gravity_;
    displacement_ = motion.displacement;
    last_ = now;
}

} // namespace fem

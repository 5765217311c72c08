// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/pair_flux.hpp"
#include "sph_solver/operators/fluid_gradients.hpp"
#include "sph_solver/operators/neighbours_in_reach.hpp"

namespace sph {

/// The fixed baseline of the benchmark: both passes one pair after the other, each pair once, as the formulas are
/// written down (raw pair areas), with plain stores to both particles.
template<int D>
void scalar_evaluation(Particles<D>& particles, Rates<D>& rates, GradientField<D>& sums,
                       const ReachedNeighbours& neighbours, const FluidModel<D>& model)
{
    const auto for_each_pair = [&](auto visit) {
        for (std::size_t i = 0; i < neighbours.rows(); ++i)
            for (const int j : neighbours.row(i, static_cast<int>(i)).behind())
                visit(i, static_cast<std::size_t>(j), Vec<D>(particles.position[j] - particles.position[i]));
    };
    sums.assign(particles.size(), {});
    for_each_pair([&](std::size_t i, std::size_t j, const Vec<D>& x) {
        const double r = x.norm();
        const Vec<D> slope = model.kernel.slope(r) / r * x, dv = particles.velocity[j] - particles.velocity[i];
        const Mat<D> moment = x * slope.transpose(), velocity = dv * slope.transpose();
        const Vec<D> density = (particles.density[j] - particles.density[i]) * slope;
        for (const auto& [k, volume] : {std::pair{i, particles.volume[j]}, std::pair{j, particles.volume[i]}}) {
            sums[k].moment += volume * moment;
            sums[k].velocity += volume * velocity;
            sums[k].density += volume * density;
        }
    });
    for (auto& sum : sums) sum.fluid_fill = sum.moment.trace() / D;
    finish_gradients(particles, sums, model);
    const auto state = [&](std::size_t k) {
        return PrimitiveState<D>{particles.density[k], particles.velocity[k], particles.density_gradient[k],
                                 particles.velocity_gradient[k]};
    };
    for_each_pair([&](std::size_t i, std::size_t j, const Vec<D>& x) {
        const double r = x.norm(), area = 2 * particles.volume[i] * particles.volume[j] * model.kernel.slope(r);
        const auto flux = pair_flux<D>(state(i), state(j), x, model.eos, VanAlbada{}, false);
        const Vec<D> momentum = area * (flux.momentum_flux + flux.pressure / r * x);
        const double opening = 0.5 * area / r * (particles.velocity[j] - particles.velocity[i]).dot(x);
        rates.volume[i] += opening;
        rates.volume[j] += opening;
        rates.mass[i] -= area * flux.mass_flux;
        rates.mass[j] += area * flux.mass_flux;
        rates.momentum[i] -= momentum;
        rates.momentum[j] += momentum;
    });
}

} // namespace sph

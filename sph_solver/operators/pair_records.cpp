// SPDX-License-Identifier: MIT
#include "sph_solver/operators/pair_records.hpp"

namespace sph {

template<int D> void PairRecords<D>::load_states(const Particles<D>& particles, const Tait& eos)
{
    const double inverse_rho0 = 1.0 / eos.rho0;
    states_.resize(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
        auto& record = states_[i].data;
        for (std::size_t a = 0; a < D; ++a) {
            record[a] = particles.position[i][a];
            record[D + a] = particles.velocity[i][a];
        }
        record[2 * D] = particles.density[i] * inverse_rho0;
        record[2 * D + 1] = particles.volume[i];
    }
}

template<int D> void PairRecords<D>::load_slopes(const Particles<D>& particles, const Tait& eos)
{
    const double inverse_rho0 = 1.0 / eos.rho0;
    slopes_.resize(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
        auto& record = slopes_[i].data;
        for (std::size_t a = 0; a < D; ++a) {
            record[a] = particles.density_gradient[i][a] * inverse_rho0;
            for (std::size_t b = 0; b < D; ++b) record[D + a * D + b] = particles.velocity_gradient[i](a, b);
        }
    }
}

template class PairRecords<2>;
template class PairRecords<3>;

} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/operators/pair_records.hpp"

namespace sph {

template<int D> void PairRecords<D>::load_state(const Particles<D>& particles, double inverse_rho0, std::size_t i)
{
    auto& record = states_[i].data;
    for (std::size_t a = 0; a < D; ++a) {
        record[a] = particles.position[i][a];
        record[D + a] = particles.velocity[i][a];
    }
    record[2 * D] = particles.density[i] * inverse_rho0;
    record[2 * D + 1] = particles.volume[i];
}

template<int D> void PairRecords<D>::load_slope(const Particles<D>& particles, double inverse_rho0, std::size_t i)
{
    auto& record = slopes_[i].data;
    for (std::size_t a = 0; a < D; ++a) {
        record[a] = particles.density_gradient[i][a] * inverse_rho0;
        for (std::size_t b = 0; b < D; ++b) record[D + a * D + b] = particles.velocity_gradient[i](a, b);
    }
}

template<int D> void PairRecords<D>::load_area(const Particles<D>& particles, std::size_t i)
{
    const Mat<D>& factor = particles.renormaliser[i];
    for (int a = 0; a < D; ++a)
        for (int b = a; b < D; ++b) {
            const std::size_t n = upper_triangle<D>(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
            (n < slope_areas ? slopes_[i].data[area_begin + n] : states_[i].data[7]) = factor(a, b);
        }
}

template<int D> void PairRecords<D>::load_shift(const Particles<D>& particles, std::size_t i)
{
    for (std::size_t a = 0; a < D; ++a) shifts_[i].data[a] = particles.shift[i][a];
}

template<int D>
void PairRecords<D>::load_states(const Particles<D>& particles, const Tait& eos, const std::vector<int>& which)
{
    states_.resize(particles.size());
    for (const int i : which) load_state(particles, 1.0 / eos.rho0, static_cast<std::size_t>(i));
}

template<int D>
void PairRecords<D>::load_slopes(const Particles<D>& particles, const FluidModel<D>& model,
                                 const std::vector<int>& which)
{
    slopes_.resize(particles.size());
    for (const int i : which) load_slope(particles, 1.0 / model.eos.rho0, static_cast<std::size_t>(i));
    if (!std::holds_alternative<RawArea>(model.pair_area))
        for (const int i : which) load_area(particles, static_cast<std::size_t>(i));
    if (!std::holds_alternative<ShiftedMotion>(model.face_motion)) return;
    shifts_.resize(particles.size());
    for (const int i : which) load_shift(particles, static_cast<std::size_t>(i));
}

template class PairRecords<2>;
template class PairRecords<3>;

} // namespace sph

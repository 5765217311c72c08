// SPDX-License-Identifier: MIT
#include "sph_solver/operators/fluid_flux.hpp"

#include "sph_solver/numerics/muscl.hpp"

namespace sph {
namespace {

/// Rows of particle i and columns of four neighbours, turned into what the face formulas read.
template<int D>
PairView<D, Pack> view_pairs(const double* state, const double* slope, const std::array<Pack, 8>& neighbour,
                             const std::array<Pack, PairRecords<D>::slope_size>& neighbour_slope)
{
    PairView<D, Pack> pair;
    for (std::size_t a = 0; a < D; ++a) {
        pair.x[a] = neighbour[a] - state[a];
        pair.velocity_jump[a] = neighbour[D + a] - state[D + a];
        pair.mean_velocity[a] = 0.5 * (neighbour[D + a] + state[D + a]);
    }
    pair.q_i = Pack{} + state[2 * D];
    pair.q_j = neighbour[2 * D];
    pair.q_slope_i = slope[0] * pair.x[0];
    pair.q_slope_j = neighbour_slope[0] * pair.x[0];
    for (std::size_t b = 1; b < D; ++b) {
        pair.q_slope_i += slope[b] * pair.x[b];
        pair.q_slope_j += neighbour_slope[b] * pair.x[b];
    }
    for (std::size_t a = 0; a < D; ++a) {
        const std::size_t row = D + a * D;
        pair.velocity_slope_i[a] = slope[row] * pair.x[0];
        pair.velocity_slope_j[a] = neighbour_slope[row] * pair.x[0];
        for (std::size_t b = 1; b < D; ++b) {
            pair.velocity_slope_i[a] += slope[row + b] * pair.x[b];
            pair.velocity_slope_j[a] += neighbour_slope[row + b] * pair.x[b];
        }
    }
    return pair;
}

/// The same sums as FluxSums, four neighbours side by side.
template<int D> struct PackedFlux {
    Pack mass{};
    std::array<Pack, D> by_mass{}, by_pressure{};

    /// \param volumes w_i w_j
    template<class AnyLimiter>
    void add(PairView<D, Pack>& pair, Pack volumes, const FluidModel<D>& model, AnyLimiter limiter)
    {
        const Tait eos = model.eos;
        const Pack r = square_root(dot(pair.x, pair.x) + 1e-300);
        pair.inverse_distance = 1.0 / r;
        const Pack area = volumes * (2.0 * model.kernel.slope(r));
        const StarState<Pack> star = solve_face(pair, 1.0 / eos.c0, limiter);
        const Pack u = eos.c0 * star.u;
        const auto velocity = face_velocity(pair, u, limiter);
        const Pack mass_flux = area * (eos.rho0 * star.q * u);
        const Pack pressure = area * eos.pressure_at_ratio(star.q) * pair.inverse_distance;
        mass -= mass_flux;
        for (std::size_t a = 0; a < D; ++a) {
            by_mass[a] -= mass_flux * velocity[a];
            by_pressure[a] -= pressure * pair.x[a];
        }
    }

    FluxSums<D> total() const
    {
        FluxSums<D> sums;
        sums.mass = sum_lanes(mass);
        for (int a = 0; a < D; ++a) {
            sums.by_mass[a] = sum_lanes(by_mass[static_cast<std::size_t>(a)]);
            sums.by_pressure[a] = sum_lanes(by_pressure[static_cast<std::size_t>(a)]);
        }
        return sums;
    }
};

template<int D, class AnyLimiter>
void sum_fluxes(FluxField<D>& sums, const PairRecords<D>& records, const NeighbourList& neighbours,
                const std::vector<int>& owned, const FluidModel<D>& model, AnyLimiter limiter)
{
    const auto state_of = [&](int j) { return records.state(j); };
    const auto slope_of = [&](int j) { return records.slope(j); };
    for (std::size_t k = 0; k < owned.size(); ++k) {
        const double* state = records.state(owned[k]);
        const double* slope = records.slope(owned[k]);
        PackedFlux<D> packed;
        for_each_pack(neighbours.of(k), owned[k], [&](const int* indices) {
            const auto neighbour = load_columns<8>(state_of, indices);
            const auto neighbour_slope = load_columns<PairRecords<D>::slope_size>(slope_of, indices);
            auto pair = view_pairs<D>(state, slope, neighbour, neighbour_slope);
            packed.add(pair, PairRecords<D>::volume(state) * neighbour[2 * D + 1], model, limiter);
        });
        sums[k] = packed.total();
    }
}

} // namespace

template<int D>
void add_fluid_fluid_flux(Rates<D>& rates, FluxField<D>& sums, const PairRecords<D>& records,
                          const NeighbourList& neighbours, const std::vector<int>& owned, const FluidModel<D>& model)
{
    sums.resize(owned.size());
    std::visit([&](auto limiter) { sum_fluxes(sums, records, neighbours, owned, model, limiter); }, model.limiter);
    for (std::size_t k = 0; k < owned.size(); ++k) {
        const auto i = static_cast<std::size_t>(owned[k]);
        rates.mass[i] += sums[k].mass;
        rates.momentum[i] += sums[k].by_mass + sums[k].by_pressure;
    }
}

template<int D> void add_gravity(Rates<D>& rates, const Particles<D>& particles, const Vec<D>& gravity)
{
    for (const int owned : particles.owned) {
        const auto i = static_cast<std::size_t>(owned);
        rates.momentum[i] += particles.mass[i] * gravity;
    }
}

template void add_fluid_fluid_flux<2>(Rates<2>&, FluxField<2>&, const PairRecords<2>&, const NeighbourList&,
                                      const std::vector<int>&, const FluidModel<2>&);
template void add_fluid_fluid_flux<3>(Rates<3>&, FluxField<3>&, const PairRecords<3>&, const NeighbourList&,
                                      const std::vector<int>&, const FluidModel<3>&);
template void add_gravity<2>(Rates<2>&, const Particles<2>&, const Vec<2>&);
template void add_gravity<3>(Rates<3>&, const Particles<3>&, const Vec<3>&);

} // namespace sph

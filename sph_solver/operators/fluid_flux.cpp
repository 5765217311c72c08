// SPDX-License-Identifier: MIT
#include "sph_solver/operators/fluid_flux.hpp"

#include "sph_solver/operators/face_batch.hpp"

#include <algorithm>
#include <cstdint>

namespace sph {
namespace {

/// Marks the local particles of some rows. Empty: all of them.
std::vector<std::uint8_t> particles_of(const RowSet& rows, std::size_t particles)
{
    std::vector<std::uint8_t> marks;
    if (rows.size() == particles) return marks;
    marks.resize(particles);
    rows.for_each([&](std::size_t, int i) { marks[static_cast<std::size_t>(i)] = 1; });
    return marks;
}

/// The neighbours before a row, where one of them has no row that could solve its face; else none.
std::span<const int> to_solve(std::span<const int> ahead, const std::vector<std::uint8_t>& marks)
{
    const bool all =
        std::all_of(ahead.begin(), ahead.end(), [&](int j) { return marks[static_cast<std::size_t>(j)] != 0; });
    return all ? std::span<const int>{} : ahead;
}

template<int D, class AnyLimiter, class Motion, class Area>
void sum_fluxes(FluxField<D>& sums, const PairRecords<D>& records, const ReachedNeighbours& neighbours,
                const RowSet& rows, const FluidModel<D>& model, std::span<std::byte> scratch, AnyLimiter limiter,
                Motion motion, Area)
{
    if (rows.size() == 0) return;
    FaceBatch<D, AnyLimiter, Motion, Area> batch(records, neighbours.longest(), model, limiter, motion, scratch);
    const auto marks = particles_of(rows, records.size());
    PairBatch& pairs = batch.pairs();
    rows.for_each([&](std::size_t k, int i) {
        if (marks.empty()) {
            pairs.take(i, k, 0, neighbours.unfold_behind(k, i, pairs.next()));
        } else {
            const ReachedRow row = neighbours.row(k, i);
            pairs.add(i, k, to_solve(row.ahead(), marks), row.behind());
        }
        if (pairs.full()) batch.solve(sums);
    });
    batch.solve(sums);
}

} // namespace

template<int D>
void add_fluid_fluid_flux(Rates<D>& rates, FluxField<D>& sums, const PairRecords<D>& records,
                          const ReachedNeighbours& neighbours, const RowSet& rows, const FluidModel<D>& model,
                          std::span<std::byte> scratch)
{
    sums.resize(rows.all());
    std::visit([&](auto limiter, auto motion,
                   auto area) { sum_fluxes(sums, records, neighbours, rows, model, scratch, limiter, motion, area); },
               model.limiter, model.face_motion, model.pair_area);
    rows.for_each([&](std::size_t k, int particle) {
        const auto i = static_cast<std::size_t>(particle);
        rates.mass[i] += sums[k].mass;
        rates.volume[i] += sums[k].dilation + sums[k].swept;
        rates.momentum[i] += sums[k].by_mass + sums[k].by_pressure;
    });
}

template<int D> void add_gravity(Rates<D>& rates, const Particles<D>& particles, const Vec<D>& gravity)
{
    for (const int owned : particles.owned) {
        const auto i = static_cast<std::size_t>(owned);
        rates.momentum[i] += particles.mass[i] * gravity;
    }
}

template void add_fluid_fluid_flux<2>(Rates<2>&, FluxField<2>&, const PairRecords<2>&, const ReachedNeighbours&,
                                      const RowSet&, const FluidModel<2>&, std::span<std::byte>);
template void add_fluid_fluid_flux<3>(Rates<3>&, FluxField<3>&, const PairRecords<3>&, const ReachedNeighbours&,
                                      const RowSet&, const FluidModel<3>&, std::span<std::byte>);
template void add_gravity<2>(Rates<2>&, const Particles<2>&, const Vec<2>&);
template void add_gravity<3>(Rates<3>&, const Particles<3>&, const Vec<3>&);

} // namespace sph

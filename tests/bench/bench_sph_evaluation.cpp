// SPDX-License-Identifier: MIT
// Directed pairs per second of one evaluation of the fluid's rates, whole and in its parts, on a jittered lattice inside the caches (2D: the
// gate at dx = 1 mm; 3D: 50,000 particles), with the method's defaults. The whole one beside the same done pair by pair, and beside what
// the core can do at most.
#include "sph_solver/neighbours/neighbour_search.hpp"
#include "sph_solver/operators/derived_fields.hpp"
#include "sph_solver/operators/fluid_flux.hpp"
#include "sph_solver/operators/fluid_gradients.hpp"
#include "sph_solver/state/canonical_order.hpp"
#include "tests/bench/counted.hpp"
#include "tests/bench/scalar_evaluation.hpp"
#include "tests/sph_solver/support/sample_fluid.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace sph;

template<int D> struct Evaluation {
    explicit Evaluation(int side)
        : dx(0.1 / side),
          model{CubicSpline<D>(1.23 * dx), Tait{1000.0, 30.0}, VanAlbada{}, Vec<D>::Zero(), {}, {}, RenormalisedArea{}},
          particles(sample::jittered_lattice<D>(side, dx, 0.1, 1000.0)),
          search(model.kernel.support(), 0.15 * model.kernel.support()),
          in_reach(model.kernel.support())
    {
        sort_canonically(particles, search.grid());
        sample::Noise noise(3);
        for (std::size_t i = 0; i < particles.size(); ++i) {
            particles.mass[i] *= 1.0 + 1e-3 * noise();
            for (int a = 0; a < D; ++a) particles.momentum[i][a] = particles.mass[i] * noise();
        }
        search.build(particles);
        rates.reset(particles.size());
        update_derived(particles, model.eos);
        select();
        gradients();
    }

    void select()
    {
        records.load_states(particles, model.eos, particles.owned);
        reached = &in_reach.select(particles, search.list());
    }

    void gradients()
    {
        accumulate_fluid_gradients(sums, records, *reached, particles.owned, model);
        finish_gradients(particles, sums, model);
    }

    void fluxes()
    {
        records.load_slopes(particles, model, particles.owned);
        add_fluid_fluid_flux(rates, fluxes_, records, *reached, particles.owned, model);
    }

    void evaluate()
    {
        update_derived(particles, model.eos);
        select();
        gradients();
        fluxes();
    }

    /// Directed pairs.
    [[nodiscard]] double pairs() const
    {
        double count = 0;
        for (std::size_t k = 0; k < reached->rows(); ++k) count += static_cast<double>(reached->of(k).size());
        return count;
    }

    /// Shortest time of the evaluation pair by pair, of three [s]; the selection is the packs' own.
    double seconds_pair_by_pair()
    {
        double least = 1e300;
        for (int n = 0; n < 3; ++n) {
            const auto start = std::chrono::steady_clock::now();
            update_derived(particles, model.eos);
            select();
            scalar_evaluation(particles, rates, sums, *reached, model);
            least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
        return least;
    }

    double dx;
    FluidModel<D> model;
    Particles<D> particles;
    NeighbourSearch<D> search;
    PairRecords<D> records;
    NeighboursInReach<D> in_reach;
    const ReachedNeighbours* reached = nullptr;
    Rates<D> rates;
    GradientField<D> sums;
    FluxField<D> fluxes_;
};

template<int D> void report(benchmark::State& state, const Evaluation<D>& evaluation)
{
    const double pairs = evaluation.pairs();
    state.counters["neighbours"] = pairs / static_cast<double>(evaluation.particles.size());
    state.counters["directed_pairs_per_s"] = benchmark::Counter(pairs, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["ns_per_pair"] =
        benchmark::Counter(pairs * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template<int D> void sph_selection(benchmark::State& state)
{
    Evaluation<D> evaluation(static_cast<int>(state.range(0)));
    for (auto _ : state) evaluation.select();
    report(state, evaluation);
}

template<int D> void sph_gradients(benchmark::State& state)
{
    Evaluation<D> evaluation(static_cast<int>(state.range(0)));
    for (auto _ : state) evaluation.gradients();
    report(state, evaluation);
}

template<int D> void sph_fluxes(benchmark::State& state)
{
    Evaluation<D> evaluation(static_cast<int>(state.range(0)));
    for (auto _ : state) evaluation.fluxes();
    report(state, evaluation);
}

template<int D> void sph_evaluation(benchmark::State& state)
{
    static const double peak = peak_flops();
    Evaluation<D> evaluation(static_cast<int>(state.range(0)));
    const double pair_by_pair = evaluation.seconds_pair_by_pair();
    const double flops = flops_of_a_directed_pair<D>(evaluation.model.kernel, evaluation.model.eos);
    evaluation.gradients();
    for (auto _ : state) evaluation.evaluate();
    report(state, evaluation);
    const double pairs = evaluation.pairs();
    using benchmark::Counter;
    const auto a_second = Counter::kIsIterationInvariantRate;
    state.counters["flops_per_pair"] = flops;
    state.counters["flops_per_s"] = Counter(flops * pairs, a_second);
    state.counters["peak_flops_per_s"] = peak;
    state.counters["share_of_peak"] = Counter(flops * pairs / peak, a_second);
    state.counters["times_pair_by_pair"] = Counter(pair_by_pair, a_second);
    state.counters["particles_per_s"] = Counter(static_cast<double>(evaluation.particles.size()), a_second);
}

BENCHMARK_TEMPLATE(sph_selection, 2)->Arg(118)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(sph_gradients, 2)->Arg(118)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(sph_fluxes, 2)->Arg(118)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(sph_evaluation, 2)->Arg(118)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(sph_selection, 3)->Arg(37)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(sph_gradients, 3)->Arg(37)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(sph_fluxes, 3)->Arg(37)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(sph_evaluation, 3)->Arg(37)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();

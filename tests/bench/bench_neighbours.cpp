// SPDX-License-Identifier: MIT
// Nanoseconds a particle of the neighbour search (cells, comparisons, list) and of the filter that takes the skin out
// at every evaluation, on a jittered lattice in canonical order (2D: the gate at dx = 1 mm; 3D: 50,000 particles).
#include "sph_solver/neighbours/neighbour_search.hpp"
#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "sph_solver/state/canonical_order.hpp"
#include "tests/sph_solver/support/sample_fluid.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace sph;

constexpr double skin = 0.15; // of the support, as in the default configuration

template<int D> struct Fluid {
    explicit Fluid(int side)
        : support(2.0 * 1.23 * 0.1 / side),
          particles(sample::jittered_lattice<D>(side, 0.1 / side, 0.1, 1000.0)),
          search(support, skin * support)
    {
        sort_canonically(particles, search.grid());
        search.build(particles);
    }

    double support;
    Particles<D> particles;
    NeighbourSearch<D> search;
};

template<class List> void report(benchmark::State& state, std::size_t particles, const List& list)
{
    const auto count = static_cast<double>(particles);
    double neighbours = 0;
    for (std::size_t k = 0; k < list.rows(); ++k) neighbours += static_cast<double>(list.of(k).size());
    state.counters["neighbours"] = neighbours / count;
    state.counters["ns_per_particle"] =
        benchmark::Counter(count * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template<int D> void neighbour_search(benchmark::State& state)
{
    Fluid<D> fluid(static_cast<int>(state.range(0)));
    for (auto _ : state) fluid.search.build(fluid.particles);
    report(state, fluid.particles.size(), fluid.search.list());
}

template<int D> void select_in_reach(benchmark::State& state)
{
    Fluid<D> fluid(static_cast<int>(state.range(0)));
    NeighboursInReach<D> in_reach(fluid.support);
    const ReachedNeighbours* reached = nullptr;
    for (auto _ : state) reached = &in_reach.select(fluid.particles, fluid.search.list());
    report(state, fluid.particles.size(), *reached);
}

BENCHMARK_TEMPLATE(neighbour_search, 2)->Arg(118)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(neighbour_search, 3)->Arg(37)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(select_in_reach, 2)->Arg(118)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(select_in_reach, 3)->Arg(37)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();

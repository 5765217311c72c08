// SPDX-License-Identifier: MIT
// Milliseconds of a step of the solid: the gate swinging under the water's follower pressure at a fluid's step of 25 us, with the
// factorisation kept over the steps as in a run, and, as the baseline, factorised anew in every step (its length changes by 3 %).
// 4 x 40 is the mesh of the gate's case.
#include "fem_solver/time/solid_step.hpp"
#include "tests/fem_solver/support/gate.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace fem;

constexpr double fluid_step = 2.5e-5; // [s]

void gate_step(benchmark::State& state, bool factorise_anew)
{
    fem_test::Gate gate(ElementType::quad8, fem_test::rubber(), {},
                        {static_cast<int>(state.range(0)), static_cast<int>(state.range(1))});
    gate.add_water();
    SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(-0.05), {});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    step.start(motion);
    bool longer = false;
    for (auto _ : state) {
        longer = factorise_anew && !longer;
        step.advance(motion, longer ? 1.03 * fluid_step : fluid_step);
    }
    const double steps = static_cast<double>(step.steps());
    state.counters["unknowns"] = static_cast<double>(gate.forces.dofs());
    state.counters["iterations_per_step"] = static_cast<double>(step.iterations()) / steps;
    state.counters["factorisations_per_step"] = static_cast<double>(step.factorisations()) / steps;
}

void gate_factorisation_kept(benchmark::State& state) { gate_step(state, false); }
void gate_factorised_anew(benchmark::State& state) { gate_step(state, true); }

BENCHMARK(gate_factorisation_kept)->Args({4, 40})->Args({4, 64})->Unit(benchmark::kMillisecond);
BENCHMARK(gate_factorised_anew)->Args({4, 40})->Args({4, 64})->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();

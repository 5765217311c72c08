// SPDX-License-Identifier: MIT
// Drops of a few particles that breathe: nothing may feed them. With slopes among so few, the midpoint rule at
// dt = 0.6 h/c0 multiplied the energy of the drop of 2 x 2 by 5e8 in 400 steps.
#include "sph_solver/operators/derived_fields.hpp"
#include "sph_solver/time/energy_ledger.hpp"
#include "sph_solver/time/fluid_step.hpp"
#include "tests/sph_solver/support/sample_fluid.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

constexpr double spacing = 0.002, c0 = 30.0;

/// A cube of side^D particles whose centre rests, v = rate x.
template<int D> struct Drop {
    Drop(int side, double rate, const std::string& integrator)
        : model{CubicSpline<D>(1.23 * spacing), Tait{1000.0, c0}, VanAlbada{}, Vec<D>::Zero()},
          search(model.kernel.support(), 0.1 * spacing),
          domain(comm, search.grid()),
          walls({.spacing = spacing, .support = model.kernel.support()}),
          step(model, RungeKutta(integrator), {domain, search, walls, outflow, timers}),
          ledger(model),
          particles(sample::jittered_lattice<D>(side, spacing, 0.0, 1000.0))
    {
        const Vec<D> centre = Vec<D>::Constant(0.5 * (side - 1) * spacing) + particles.position[0];
        for (std::size_t i = 0; i < particles.size(); ++i)
            particles.momentum[i] = particles.mass[i] * rate * (particles.position[i] - centre);
        step.add_observer(ledger);
        step.prepare(particles);
    }

    double energy() { return ledger.balance(particles, outflow, comm).total; }

    base::Communicator comm = base::Communicator::world();
    FluidModel<D> model;
    NeighbourSearch<D> search;
    Domain<D> domain;
    Walls<D> walls;
    Outflow<D> outflow;
    base::TimerTree timers;
    FluidStep<D> step;
    EnergyLedger<D> ledger;
    Particles<D> particles;
};

template<int D> void expect_no_growth(int side, const char* integrator = "rk2", double cfl = 0.6)
{
    Drop<D> drop(side, 0.1, integrator);
    const double start = drop.energy();
    for (int k = 0; k < 400; ++k) drop.step.advance(drop.particles, cfl * 1.23 * spacing / c0);
    EXPECT_GT(start, 0.0);
    EXPECT_LE(drop.energy(), start) << side << " particles wide, dimension " << D;
}

TEST(SmallDrop, IsNotFedByTheTimeStep)
{
    expect_no_growth<2>(2);
    expect_no_growth<2>(3);
    expect_no_growth<3>(2);
    for (const int side : {2, 3}) expect_no_growth<2>(side, "hybrid3", 1.4);
    expect_no_growth<3>(2, "hybrid3", 1.4);
}

} // namespace
} // namespace sph

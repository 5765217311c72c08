// SPDX-License-Identifier: MIT
// A disc of water that is pulled into an ellipse (Colagrossi 2005): no walls, no gravity, energy known. Small and
// short here.
#include "sph_solver/operators/derived_fields.hpp"
#include "sph_solver/time/energy_ledger.hpp"
#include "sph_solver/time/fluid_step.hpp"
#include "tests/sph_solver/support/sample_fluid.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

constexpr double dx = 0.08;

/// The disc on a lattice, v = (-x, y), p = rho0 (1 - r^2)/2; `share` of `shares` equal parts.
Particles<2> make_disc(const Tait& water, int share, int shares)
{
    Particles<2> disc;
    std::int64_t id = 0;
    const int half = static_cast<int>(1 / dx) + 1;
    for (int row = -half; row <= half; ++row)
        for (int column = -half; column <= half; ++column) {
            const Vec<2> x((column + 0.5) * dx, (row + 0.5) * dx);
            if (x.norm() > 1.0 || id++ % shares != share) continue;
            const double rho = water.density(0.5 * water.rho0 * (1 - x.squaredNorm()));
            disc.resize(disc.size() + 1);
            const std::size_t i = disc.size() - 1;
            disc.id[i] = id;
            disc.position[i] = x;
            disc.volume[i] = dx * dx;
            disc.mass[i] = rho * dx * dx;
            disc.momentum[i] = disc.mass[i] * Vec<2>(-x[0], x[1]);
        }
    disc.own_all();
    return disc;
}

struct Patch {
    Patch(const base::Communicator& communicator, const Limiter& limiter, const Vec<2>& gravity = Vec<2>::Zero(),
          const std::string& integrator = "rk2")
        : comm(communicator),
          model{CubicSpline<2>(1.23 * dx), Tait{1000.0, 10.0}, limiter, gravity},
          search(model.kernel.support(), 0.1 * dx),
          domain(comm, search.grid()),
          walls({.spacing = dx, .support = model.kernel.support()}),
          step(model, RungeKutta(integrator), {domain, search, walls, outflow, timers}),
          ledger(model),
          particles(make_disc(model.eos, comm.rank(), comm.size()))
    {
        step.add_observer(ledger);
        step.prepare(particles);
        start = ledger.balance(particles, outflow, comm);
    }

    EnergyBalance run(double time, int steps)
    {
        for (int k = 0; k < steps; ++k) step.advance(particles, time / steps);
        return ledger.balance(particles, outflow, comm);
    }

    base::Communicator comm;
    FluidModel<2> model;
    NeighbourSearch<2> search;
    Domain<2> domain;
    Walls<2> walls;
    Outflow<2> outflow;
    base::TimerTree timers;
    FluidStep<2> step;
    EnergyLedger<2> ledger;
    Particles<2> particles;
    EnergyBalance start;
};

constexpr double end = 0.2;
constexpr int coarse = 36; // dt = 0.56 h/c0

/// \param usual_steps up to `end`, about the longest that the integrator is meant for
/// \param allowed error then, as a part of the energy
void expect_second_order_of_the_ledger(const char* integrator, int usual_steps, double allowed)
{
    const auto run = [&](int steps) {
        return Patch(base::Communicator::world(), VanAlbada{}, Vec<2>::Zero(), integrator).run(end, steps);
    };
    const auto usual = run(usual_steps), fine = run(6 * usual_steps), finer = run(12 * usual_steps);
    EXPECT_LT(std::abs(usual.balance_error), allowed * usual.total);
    EXPECT_LT(std::abs(usual.balance_error), 500 * allowed * usual.dissipation_riemann)
        << "the dissipations explain the loss";
    EXPECT_GT(usual.dissipation_mass_flux, 0.0);
    EXPECT_GT(std::abs(fine.balance_error), 1e-8 * fine.total) << "too small to show an order";
    EXPECT_LT(std::abs(finer.balance_error), 0.33 * std::abs(fine.balance_error));
}

TEST(StretchingPatch, LedgerClosesAtSecondOrder)
{
    expect_second_order_of_the_ledger("rk2", coarse, 1e-5);
    expect_second_order_of_the_ledger("hybrid3", coarse * 3 / 7, 2e-5);
}

/// As long a step as "hybrid3" is meant for loses a tenth less than the midpoint rule at its own.
TEST(StretchingPatch, KeptSlopesLoseNoMoreEnergy)
{
    const auto world = base::Communicator::world();
    Patch usual(world, VanAlbada{}), kept(world, VanAlbada{}, Vec<2>::Zero(), "hybrid3");
    const double loss = usual.start.total - usual.run(end, coarse).total;
    const double kept_loss = kept.start.total - kept.run(end, coarse * 3 / 7).total;
    EXPECT_GT(loss, 0.0);
    EXPECT_LT(kept_loss, loss);
    EXPECT_GT(kept_loss, 0.8 * loss);
}

TEST(StretchingPatch, LedgerClosesUnderGravity)
{
    const auto world = base::Communicator::world();
    const Vec<2> gravity(0.3, -2.0);
    Patch coarse_patch(world, VanAlbada{}, gravity), fine_patch(world, VanAlbada{}, gravity);
    const auto one = coarse_patch.run(end, coarse), half = fine_patch.run(end, 2 * coarse);
    EXPECT_GT(std::abs(one.potential - coarse_patch.start.potential), 1.0);
    EXPECT_LT(std::abs(half.balance_error), 0.35 * std::abs(one.balance_error));
}

TEST(StretchingPatch, MassAndMomentumAreConstantToRoundOff)
{
    Patch patch(base::Communicator::world(), VanAlbada{});
    const auto later = patch.run(end, coarse);
    EXPECT_LT(std::abs(later.mass - patch.start.mass), 1e-13 * patch.start.mass);
    for (std::size_t a = 0; a < 2; ++a)
        EXPECT_LT(std::abs(later.momentum[a] - patch.start.momentum[a]), 1e-12 * patch.start.mass);
}

TEST(StretchingPatch, ReconstructionSavesTheEnergy)
{
    const auto world = base::Communicator::world();
    Patch second(world, VanAlbada{}), first(world, FirstOrder{});
    const double total = second.start.total;
    const double loss = total - second.run(end, coarse).total, first_loss = total - first.run(end, coarse).total;
    EXPECT_GT(loss, 0.0);
    EXPECT_LT(loss, 0.01 * total);
    EXPECT_GT(first_loss, 10 * loss);
}

void expect_same_on_all_ranks(const char* integrator)
{
    Patch together(base::Communicator::world(), VanAlbada{}, Vec<2>::Zero(), integrator);
    Patch alone(base::Communicator::self(), VanAlbada{}, Vec<2>::Zero(), integrator);
    const auto shared = together.run(end, coarse), single = alone.run(end, coarse);
    EXPECT_GT(together.step.rebuilds(), 2);
    EXPECT_EQ(together.step.rebuilds(), alone.step.rebuilds());
    EXPECT_EQ(shared.kinetic, single.kinetic);
    EXPECT_EQ(shared.internal, single.internal);
    EXPECT_EQ(shared.dissipation_riemann, single.dissipation_riemann);
    EXPECT_EQ(shared.dissipation_mass_flux, single.dissipation_mass_flux);
    EXPECT_EQ(shared.balance_error, single.balance_error);
    for (const int owned : together.particles.owned) {
        const auto i = static_cast<std::size_t>(owned);
        const auto& ids = alone.particles.id;
        const auto k =
            static_cast<std::size_t>(std::find(ids.begin(), ids.end(), together.particles.id[i]) - ids.begin());
        EXPECT_EQ(together.particles.position[i], alone.particles.position[k]);
        EXPECT_EQ(together.particles.momentum[i], alone.particles.momentum[k]);
    }
}

TEST(StretchingPatch, DoesNotDependOnTheNumberOfRanks)
{
    expect_same_on_all_ranks("rk2");
    expect_same_on_all_ranks("hybrid3");
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "fem_solver/assembly/impedance_load.hpp"
#include "fem_solver/mesh/linear_facets.hpp"
#include "fem_solver/time/solid_step.hpp"
#include "tests/fem_solver/support/gate.hpp"
#include "tests/fem_solver/support/record.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

/// Largest |balance error| and peak work of a sudden load with gravity, damping and steps of changing length.
struct Balance {
    double error = 0, work = 0;
    long factorisations = 0;
};

Balance run(double tolerance, double alpha)
{
    Gate gate(ElementType::quad8, rubber(), {}, {1, 8});
    gate.add_water();
    gate.forces.set_gravity({0, -9.81});
    gate.forces.set_damping({1e-5, 0.5});
    SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(alpha), {{tolerance, 50, 0.1}});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    step.start(motion);
    Balance balance;
    for (int i = 0; i < 150; ++i) {
        step.advance(motion, i % 50 < 25 ? 2e-4 : 3e-4);
        const SolidEnergies& e = step.energies();
        balance.error = std::max(balance.error, std::abs(e.balance_error));
        balance.work = std::max({balance.work, std::abs(e.work_loads), e.strain});
    }
    balance.factorisations = step.factorisations();
    return balance;
}

TEST(EnergyIdentity, ClosesToRoundOffWithATightTolerance)
{
    for (const double alpha : {0.0, -0.05, -0.3}) {
        const Balance balance = run(1e-14, alpha);
        EXPECT_GT(balance.work, 0.5);
        EXPECT_LT(balance.error, 1e-12 * balance.work) << "alpha " << alpha;
        if (alpha == -0.05) record("hht_identity_over_work", balance.error / balance.work);
    }
}

TEST(EnergyIdentity, ErrorFollowsTheNewtonTolerance)
{
    const Balance loose = run(1e-5, -0.05), tight = run(1e-8, -0.05);
    EXPECT_LT(tight.error, 1e-8 * tight.work);
    EXPECT_GT(loose.error, 20 * tight.error);
}

/// A constant velocity far from the start, nothing acting: all energies stay as they are.
TEST(EnergyIdentity, FreeFlightChangesNothing)
{
    Gate gate(ElementType::quad8, rubber(), {}, {1, 4});
    const Supports free(gate.mesh);
    SolidStep step(gate.mesh, gate.forces, free, Hht(-0.05), {});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    motion.velocity.setConstant(3);
    step.start(motion);
    const double kinetic = step.energies().kinetic;
    for (int i = 0; i < 20; ++i) step.advance(motion, 1e-3);
    EXPECT_NEAR(kinetic, 0.5 * 1100 * 0.005 * 0.079 * 18, 1e-12);
    EXPECT_NEAR(step.energies().kinetic, kinetic, 1e-11);
    EXPECT_NEAR(motion.displacement[gate.tip], 0.06, 1e-13);
}

/// The impedance's work is part of the interface's, counted apart, and it takes energy out.
TEST(EnergyIdentity, ImpedanceWorkIsBooked)
{
    Gate gate(ElementType::quad8, rubber(), {}, {1, 8});
    gate.add_water();
    const auto facets = linear_facets(gate.mesh, gate.mesh.faces("left"));
    auto load = std::make_unique<ImpedanceLoad>(gate.mesh, gate.forces.pattern(), facets);
    ImpedanceLoad& impedance = *load;
    gate.forces.set_correction(std::move(load));
    SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(-0.05), {{1e-13, 50, 0.1}});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    step.start(motion);
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(gate.forces.dofs());
    for (int i = 0; i < 100; ++i) {
        impedance.set(1000, std::vector<char>(facets.size(), 1), motion.displacement, still);
        step.advance(motion, 2e-4);
    }
    const SolidEnergies& e = step.energies();
    EXPECT_LT(e.work_correction, -0.05 * e.work_loads);
    EXPECT_EQ(e.work_interface, e.work_correction);
    EXPECT_LT(std::abs(e.balance_error), 1e-12 * e.work_loads);
}

} // namespace

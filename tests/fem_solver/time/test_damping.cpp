// SPDX-License-Identifier: MIT
// Rayleigh damping: the first mode of the gate decays with the ratio (eta w + m/w)/2, and the loss is what is booked.
#include "fem_solver/solve/band_solver.hpp"
#include "fem_solver/time/solid_step.hpp"
#include "tests/fem_solver/support/gate.hpp"
#include "tests/fem_solver/support/record.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

struct Mode {
    double w; ///< [rad/s]
    Eigen::VectorXd shape;
};

/// By inverse iteration on K x = w^2 M x.
Mode first_mode(const Gate& gate)
{
    Matrix stiffness = gate.forces.initial_stiffness();
    gate.supports.clear(stiffness, stiffness.diagonal().mean());
    BandSolver solver;
    solver.factorise(stiffness);
    Eigen::VectorXd x = Eigen::VectorXd::Ones(stiffness.rows());
    for (int i = 0; i < 30; ++i) {
        x = gate.forces.inertia(x);
        gate.supports.clear_rows(x);
        x = solver.solve(x).normalized();
    }
    return {std::sqrt(x.dot(gate.forces.initial_stiffness() * x) / x.dot(gate.forces.inertia(x))), x};
}

TEST(RayleighDamping, FirstModeDecaysWithItsRatio)
{
    Gate gate(ElementType::quad8, SmallElastic{Lame::from_young(12e6, 0.4)}, {}, {1, 8});
    const Mode mode = first_mode(gate);
    const double eta = 2e-4, mass = 2, ratio = 0.5 * (eta * mode.w + mass / mode.w);
    gate.forces.set_damping({eta, mass});
    SolidStep step(gate.mesh, gate.forces, gate.supports, Hht(0), {{1e-13, 50, 0.1}});
    Motion motion = Motion::at_rest(gate.forces.dofs());
    motion.displacement = 1e-3 * mode.shape;
    motion.velocity = -ratio * mode.w * motion.displacement; // as in exp(-ratio w t) cos(w_d t)
    step.start(motion);
    const double total = step.energies().total(), period = 2 * M_PI / (mode.w * std::sqrt(1 - ratio * ratio));
    const int steps = 400, periods = 10;
    for (int i = 0; i < steps * periods; ++i) step.advance(motion, period / steps);
    const double left = motion.displacement.dot(mode.shape) / 1e-3;
    const double measured = -std::log(left) / (periods * mode.w * period);
    EXPECT_NEAR(measured / ratio, 1, 1e-3);
    const SolidEnergies& e = step.energies();
    EXPECT_NEAR(e.damping / (total * (1 - std::exp(-2 * ratio * mode.w * periods * period))), 1, 2e-3);
    EXPECT_LT(std::abs(e.balance_error), 1e-10 * total);
    record("rayleigh_ratio_over_exact", measured / ratio);
}

} // namespace

// SPDX-License-Identifier: MIT
// A gate of rubber that softens, under water that is there at once and then stays: it swings and loses energy.
#include "fem_solver/time/solid_step.hpp"
#include "tests/fem_solver/support/gate.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

struct Swing {
    SolidEnergies end;
    double first = 0, second = 0; ///< largest ux of the tip, first and second swing [m]
};

Swing let_swing(double dt, const Softening& softening)
{
    const Gate gate(ElementType::quad9, rubber(), {}, {1, 6});
    SolidForces forces(gate.mesh, {rubber(), 1100, Sheet::plane_strain, softening}, {});
    forces.add_load(make_follower_pressure(gate.mesh, forces.pattern(), gate.mesh.faces("left"),
                                           [](const double* x) { return 500 * 9.81 * (0.14 - x[1]); }));
    Supports supports(gate.mesh);
    supports.fix("top", {"x", "y"});
    SolidStep step(gate.mesh, forces, supports, Hht(0), {{1e-10, 50, 0.1}});
    Motion motion = Motion::at_rest(forces.dofs());
    step.start(motion);
    Swing result;
    bool back = false;
    double least = 1;
    for (int i = 0; i < std::lround(0.35 / dt); ++i) {
        step.advance(motion, dt);
        const double ux = motion.displacement[gate.tip];
        if (!back) result.first = std::max(result.first, ux);
        back = back || ux < 0.6 * result.first;
        if (back) least = std::min(least, ux);
        if (back && least < ux) result.second = std::max(result.second, ux);
    }
    result.end = step.energies();
    return result;
}

TEST(SofteningGate, LosesInTheMaterialWhatTheLoadGaveIt)
{
    const Softening softening{2, 50, 0.1};
    const Swing coarse = let_swing(1e-3, softening), fine = let_swing(5e-4, softening), elastic = let_swing(1e-3, {});
    EXPECT_EQ(elastic.end.material, 0);
    EXPECT_GT(fine.end.material, 0.02 * fine.end.strain);
    EXPECT_NEAR(fine.end.material, coarse.end.material, 0.02 * fine.end.material); // of the path, not of the step
    // What the steps lose beside that vanishes with them: the material's own is booked right.
    EXPECT_LT(std::abs(fine.end.numerical_dissipation), 0.4 * std::abs(coarse.end.numerical_dissipation));
    EXPECT_LT(std::abs(fine.end.numerical_dissipation), 0.05 * fine.end.material);
    EXPECT_LT(std::abs(fine.end.balance_error), 1e-8 * fine.end.work_loads);
    EXPECT_LT(fine.second, 0.95 * elastic.second); // it does not come as far again
}

} // namespace

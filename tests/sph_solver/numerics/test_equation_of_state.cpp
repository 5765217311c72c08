// SPDX-License-Identifier: MIT
#include "sph_solver/numerics/equation_of_state.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

const Tait water{1000.0, 30.0};

TEST(Tait, ReferenceState)
{
    EXPECT_EQ(water.pressure(1000.0), 0.0);
    EXPECT_EQ(water.sound_speed(1000.0), 30.0);
    EXPECT_EQ(water.specific_internal_energy(1000.0), 0.0);
    EXPECT_EQ(water.specific_enthalpy(1000.0), 0.0);
    EXPECT_NEAR(water.stiffness(), 1000.0 * 900.0 / 7.0, 1e-9);
}

TEST(Tait, SoundSpeedIsTheSlopeOfThePressure)
{
    for (const double rho : {700.0, 990.0, 1000.0, 1030.0, 1300.0}) {
        const double step = 1e-3;
        const double slope = (water.pressure(rho + step) - water.pressure(rho - step)) / (2 * step);
        EXPECT_NEAR(std::sqrt(slope), water.sound_speed(rho), 1e-6 * water.sound_speed(rho)) << rho;
    }
}

TEST(Tait, DensityInvertsPressure)
{
    for (const double rho : {700.0, 999.9999, 1000.0, 1000.001, 1300.0})
        EXPECT_NEAR(water.density(water.pressure(rho)), rho, 1e-12 * rho);
}

TEST(Tait, InternalEnergyIsTheWorkOfCompression)
{
    for (const double rho : {700.0, 950.0, 999.0, 1001.0, 1050.0, 1300.0}) {
        constexpr int intervals = 2000; // Simpson's rule for int p / rho^2 drho
        const double step = (rho - 1000.0) / intervals;
        double sum = 0;
        for (int k = 0; k <= intervals; ++k) {
            const double r = 1000.0 + k * step;
            const double simpson = k == 0 || k == intervals ? 1 : (k % 2 == 1 ? 4 : 2);
            sum += simpson * water.pressure(r) / (r * r);
        }
        const double energy = sum * step / 3;
        EXPECT_NEAR(water.specific_internal_energy(rho), energy, 1e-9 * energy) << rho;
        EXPECT_NEAR(water.specific_enthalpy(rho), energy + water.pressure(rho) / rho,
                    1e-9 * std::abs(water.specific_enthalpy(rho)));
    }
}

TEST(Tait, InternalEnergyKeepsItsDigitsAtSmallCompression)
{
    const double e = 0x1p-30; // u = c0^2 e^2 / 2 (1 + O(e)); the two terms of u are 1e9 times larger
    const double exact = 0.5 * 900.0 * e * e;
    EXPECT_NEAR(water.specific_internal_energy(1000.0 * (1 + e)), exact, 2e-6 * exact);
}

} // namespace
} // namespace sph

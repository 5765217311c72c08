// SPDX-License-Identifier: MIT
// The gate's natural frequencies by elements of all kinds, and what locking does to them.
#include "fem_solver/modal/modal_analysis.hpp"
#include "tests/fem_solver/support/gate.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

/// The first three natural frequencies [Hz].
Eigen::Vector3d frequencies(const Gate& gate)
{
    const auto modes = find_modes(gate.mesh, gate.forces, gate.supports, Motion::at_rest(gate.forces.dofs()), 0, 3);
    return {modes[0].frequency(), modes[1].frequency(), modes[2].frequency()};
}

const Eigen::Vector3d continuum(14.740, 90.386, 244.997); // [Hz]

TEST(GateModes, QuadraticElements)
{
    const Eigen::Vector3d f = frequencies(Gate(ElementType::quad8, rubber()));
    EXPECT_LT((f.cwiseQuotient(continuum).array() - 1).abs().maxCoeff(), 0.01);
    EXPECT_NEAR(frequencies(Gate(ElementType::quad8, rubber(12e6, 0.499)))[0] / 15.63, 1, 0.01);
}

TEST(GateModes, NearlyIncompressibleWithAPressureField)
{
    EXPECT_NEAR(frequencies(Gate(ElementType::quad9, rubber(12e6, 0.499)))[0] / 15.63, 1, 0.01);
    EXPECT_NEAR(frequencies(Gate(ElementType::quad9, rubber(12e6, 0.49999)))[0], 15.7, 0.1); // 15.6 to 15.8
    const Gate six(ElementType::tri6, rubber(12e6, 0.499), {false, Formulation::mixed});
    EXPECT_NEAR(frequencies(six)[0] / 15.63, 1, 0.02);
}

TEST(GateModes, LinearElementsWithAndWithoutTheirCure)
{
    const Eigen::Vector3d f = frequencies(Gate(ElementType::quad4, rubber()));
    EXPECT_LT((f.cwiseQuotient(continuum).array() - 1).abs().maxCoeff(), 0.02);
    EXPECT_NEAR(frequencies(Gate(ElementType::quad4, rubber(12e6, 0.499)))[0] / 15.63, 1, 0.02);
    EXPECT_NEAR(frequencies(Gate(ElementType::quad4, rubber(12e6, 0.499), {false, Formulation::standard}))[0], 47.2,
                0.5); // locked
}

} // namespace

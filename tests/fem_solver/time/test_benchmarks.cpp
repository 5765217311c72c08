// SPDX-License-Identifier: MIT
// Large deformations with exact or converged answers: beams as elastica, Cook's membrane, the thick cylinder.
#include "fem_solver/assembly/surface_traction.hpp"
#include "tests/fem_solver/support/bench.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;
using namespace fem_test;

/// A beam along x so slender (L/h = 200) that shear and stretch are below 1e-4; nu = 0 makes plane strain a beam.
struct Beam : Bench {
    static constexpr double length = 1, height = 0.005, young = 1e9;
    static constexpr double bending = young * height * height * height / 12; // E I per depth [N m]

    explicit Beam(ElementType type = ElementType::quad8)
        : Bench(
              type, {40, 1},
              [](double s, double t) -> std::array<double, 2> {
                  return {s * length, (t - 0.5) * height};
              },
              SaintVenantKirchhoff{Lame::from_young(young, 0)})
    {
        supports.fix("left", {"x", "y"});
    }
    int tip() const { return 2 * mesh.nearest_node({length, 0}); }
    /// Turn of the end face [rad].
    double angle(const Eigen::VectorXd& u) const
    {
        const int low = mesh.nearest_node({length, -0.5 * height}), high = mesh.nearest_node({length, 0.5 * height});
        return std::atan2(u[2 * low] - u[2 * high], height + u[2 * high + 1] - u[2 * low + 1]);
    }
};

// K. E. Bisshopp, D. C. Drucker, Quart. Appl. Math. 3 (1945) 272, evaluated for P L^2/EI = 4.
TEST(Elastica, DeadEndShear)
{
    Beam beam;
    beam.add_traction("right", {0, 4 * Beam::bending / Beam::height});
    const Eigen::VectorXd u = beam.rest(10);
    EXPECT_NEAR(-u[beam.tip()] / 0.328941, 1, 0.002);
    EXPECT_NEAR(u[beam.tip() + 1] / 0.669964, 1, 0.002);
    EXPECT_NEAR(beam.angle(u) / 1.121239, 1, 0.002);
}

TEST(Elastica, FollowerEndShear)
{
    Beam beam;
    beam.forces.add_load(make_follower_traction(beam.mesh, beam.forces.pattern(), beam.mesh.faces("right"),
                                                {0, 4 * Beam::bending / Beam::height}));
    const Eigen::VectorXd u = beam.rest(10);
    EXPECT_NEAR(-u[beam.tip()] / 0.657254, 1, 0.002);
    EXPECT_NEAR(u[beam.tip() + 1] / 0.786168, 1, 0.002);
}

/// A pressure that changes linearly over the end face is a moment; M L/EI = pi bends the beam to half a circle.
TEST(Elastica, EndMomentBendsToACircle)
{
    Beam beam;
    const double moment = M_PI * Beam::bending, slope = 12 * moment / std::pow(Beam::height, 3);
    beam.add_pressure("right", [=](const double* x) { return slope * x[1]; });
    const Eigen::VectorXd u = beam.rest(10);
    EXPECT_NEAR(-u[beam.tip()], 1, 0.002);
    EXPECT_NEAR(u[beam.tip() + 1] / (2 / M_PI), 1, 0.002);
    EXPECT_NEAR(std::abs(beam.angle(u)) / M_PI, 1, 0.002);
}

double cook(ElementType type, int cells, Formulation formulation)
{
    const double young = 240.565, nu = 0.4999;
    Bench plate(type, {cells, cells},
                [](double s, double t) -> std::array<double, 2> {
                    return {48 * s, 44 * s + t * (44 - 28 * s)};
                },
                NeoHookean{Lame::from_young(young, nu)}, {false, formulation});
    plate.supports.fix("left", {"x", "y"});
    plate.add_traction("right", {0, 100.0 / 16});
    return plate.rest(8)[2 * plate.mesh.nearest_node({48, 60}) + 1];
}

TEST(Cook, NearlyIncompressible)
{
    EXPECT_NEAR(cook(ElementType::quad9, 8, Formulation::mixed) / 6.93, 1, 0.01);
    EXPECT_NEAR(cook(ElementType::quad4, 32, Formulation::mixed) / 6.93, 1, 0.01);
    EXPECT_NEAR(cook(ElementType::tri6, 8, Formulation::mixed) / 6.93, 1, 0.02);
    EXPECT_LT(cook(ElementType::quad4, 16, Formulation::standard), 0.75 * 6.93); // locks
}

/// Inner radius' displacement [mm] of a quarter of the cylinder A = 10, B = 20 mm, mu = 4 MPa, under inner pressure.
double cylinder_bulge(ElementType type, std::vector<int> cells, double pressure)
{
    const double mu = 4e6, bulk = 1e4 * mu;
    Bench quarter(type, std::move(cells),
                  [](double s, double t) -> std::array<double, 2> {
                      const double r = 0.01 * (1 + s), angle = 0.5 * M_PI * t;
                      return {r * std::cos(angle), r * std::sin(angle)};
                  },
                  NeoHookean{Lame{mu, bulk - 2 * mu / 3}}, {false, Formulation::mixed});
    quarter.supports.fix("bottom", {"y"});
    quarter.supports.fix("top", {"x"});
    quarter.add_pressure("left", [=](const double*) { return pressure; });
    return 1e3 * quarter.rest(8)[2 * quarter.mesh.nearest_node({0.01, 0})];
}

// Exact answers of an incompressible neo-Hookean tube.
TEST(ThickCylinder, InnerPressure)
{
    const std::array<double, 4> exact{0.943392, 2.189366, 3.964271, 6.881065};
    for (int k = 0; k < 4; ++k) {
        const double inner = cylinder_bulge(ElementType::quad9, {6, 8}, 0.5e6 * (k + 1));
        EXPECT_NEAR(inner / exact[k], 1, 0.01) << k;
        EXPECT_NEAR(cylinder_bulge(ElementType::quad4, {16, 24}, 0.5e6 * (k + 1)) / exact[k], 1, 0.01) << k;
    }
}

} // namespace

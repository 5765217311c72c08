// SPDX-License-Identifier: MIT
#include "sph_solver/numerics/riemann.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace sph {
namespace {

const Tait liquid{1000.0, 30.0};

/// Velocity change across the wave that leads from state K to rho: the textbook formulas, nothing shared with the
/// solver.
double wave(double rho, double rho_k)
{
    const double p = liquid.stiffness() * (std::pow(rho / 1000.0, 7) - 1),
                 p_k = liquid.stiffness() * (std::pow(rho_k / 1000.0, 7) - 1);
    if (rho > rho_k) return std::sqrt((p - p_k) * (1 / rho_k - 1 / rho)); // Rankine-Hugoniot
    return 30.0 * (std::pow(rho / 1000.0, 3) - std::pow(rho_k / 1000.0, 3)) /
           3; // Riemann invariant, 2 (c - c_k) / (gamma - 1)
}

/// The exact solution by bisection.
RiemannSolution bisect(const RiemannState& left, const RiemannState& right)
{
    double low = 1.0, high = 5000.0;
    for (int k = 0; k < 200; ++k) {
        const double middle = 0.5 * (low + high);
        (wave(middle, left.rho) + wave(middle, right.rho) + right.u - left.u > 0 ? high : low) = middle;
    }
    const double rho = 0.5 * (low + high);
    return {rho, 0.5 * (left.u + right.u + wave(rho, right.rho) - wave(rho, left.rho)), liquid.pressure(rho)};
}

double pressure_error(double largest_jump)
{
    double error = 0;
    for (double jump = -largest_jump; jump <= largest_jump; jump += largest_jump / 32)
        for (const double rho_l : {985.0, 1000.0, 1015.0})
            for (const double rho_r : {990.0, 1000.0, 1010.0}) {
                const RiemannState left{rho_l, 0.5 * jump * 30.0}, right{rho_r, -0.5 * jump * 30.0};
                const auto exact = bisect(left, right), found = solve_riemann(left, right, liquid);
                error = std::max(error, std::abs(found.p - exact.p) / (1000.0 * 900.0));
                error = std::max(error, std::abs(found.u - exact.u) / 30.0);
            }
    return error;
}

TEST(Riemann, AgreesWithBisection)
{
    EXPECT_LT(pressure_error(0.06), 1e-10);
    EXPECT_LT(pressure_error(0.1), 1e-9);
    EXPECT_LT(pressure_error(0.5), 1e-5);
}

TEST(Riemann, EqualStatesStay)
{
    for (const double rho : {900.0, 1000.0, 1100.0}) {
        const auto star = solve_riemann({rho, 2.5}, {rho, 2.5}, liquid);
        EXPECT_NEAR(star.rho, rho, 1e-12 * rho);
        EXPECT_NEAR(star.u, 2.5, 1e-14);
        EXPECT_NEAR(star.p, liquid.pressure(rho), 1e-9);
    }
}

TEST(Riemann, MirrorGivesTheSamePressureAndTheOppositeVelocity)
{
    for (const double jump : {-8.0, -0.3, 0.01, 1.7, 15.0}) {
        const auto star = solve_riemann({1011.0, jump}, {996.5, 0.123}, liquid);
        const auto mirror = solve_riemann({996.5, -0.123}, {1011.0, -jump}, liquid);
        EXPECT_EQ(star.rho, mirror.rho);
        EXPECT_EQ(star.p, mirror.p);
        EXPECT_EQ(star.u, -mirror.u);
    }
}

TEST(Riemann, CommonVelocityOnlyShiftsTheSolution)
{
    const auto star = solve_riemann({1011.0, 1.0}, {996.5, -0.5}, liquid);
    const auto shifted = solve_riemann({1011.0, 1.0 + 64.0}, {996.5, -0.5 + 64.0}, liquid); // exact in binary
    EXPECT_NEAR(shifted.p, star.p, 1e-9);
    EXPECT_NEAR(shifted.u, star.u + 64.0, 1e-13);
}

TEST(Riemann, StrongRarefactionsStayAboveVacuum)
{
    for (const double u : {5.0, 10.0, 20.0, 100.0, 1000.0}) {
        const auto star = solve_riemann({1000.0, -u}, {1000.0, u}, liquid);
        EXPECT_GT(star.rho, 0.0);
        EXPECT_GE(star.p, -liquid.stiffness());
        EXPECT_EQ(star.u, 0.0);
    }
}

TEST(Riemann, StrongShocksStayFinite)
{
    for (const double u : {15.0, 30.0, 60.0}) {
        const auto star = solve_riemann({1000.0, u}, {1000.0, -u}, liquid);
        const auto exact = bisect({1000.0, u}, {1000.0, -u});
        EXPECT_NEAR(star.rho, exact.rho, 0.01 * exact.rho) << "closing speed over c0: " << 2 * u / 30.0;
    }
}

TEST(Riemann, PackGivesTheSameBits)
{
    const FaceStates<Pack> faces{Pack{1.0, 1.01, 0.99, 1.2}, Pack{0.1, -0.02, 0.3, 0.0}, Pack{1.0, 0.98, 1.01, 0.9},
                                 Pack{-0.1, 0.01, 0.2, 0.0}};
    const auto packed = ExactRiemann{}(faces);
    for (std::size_t k = 0; k < pack_lanes; ++k) {
        const auto one = ExactRiemann{}(FaceStates<double>{faces.q_l[k], faces.u_l[k], faces.q_r[k], faces.u_r[k]});
        EXPECT_EQ(packed.q[k], one.q);
        EXPECT_EQ(packed.u[k], one.u);
    }
}

/// Largest difference to the exact pressure over rho0 c0^2, for two streams that meet or part at `jump` c0.
template<class Solver> double pressure_error(double jump)
{
    const FaceStates<double> face{1.0, 0.5 * jump, 1.0, -0.5 * jump};
    return std::abs(liquid.pressure_at_ratio(Solver{}(face).q) - liquid.pressure_at_ratio(ExactRiemann{}(face).q)) /
           (liquid.rho0 * liquid.c0 * liquid.c0);
}

TEST(Riemann, SimplerSolversAgreeForWeakWavesAndDifferForStrongOnes)
{
    for (const double sign : {1.0, -1.0}) {
        EXPECT_LT(pressure_error<TwoRarefactionRiemann>(sign * 1e-3), 1e-10); // third order: (2/3) (jump/2)^3 = 8.3e-11
        EXPECT_LT(pressure_error<AcousticRiemann>(sign * 1e-3), 1e-6);
    }
    EXPECT_LT(pressure_error<TwoRarefactionRiemann>(-0.1), 1e-12); // two rarefactions indeed
    EXPECT_GT(pressure_error<TwoRarefactionRiemann>(0.1), 1e-5);
    EXPECT_GT(pressure_error<AcousticRiemann>(0.1), 1e-3);
}

TEST(Riemann, SimplerSolversAreMirrorSymmetric)
{
    const FaceStates<double> face{1.01, 0.02, 0.99, -0.01}, mirror{0.99, 0.01, 1.01, -0.02};
    const auto check = [&](auto solver) {
        EXPECT_EQ(solver(face).q, solver(mirror).q);
        EXPECT_EQ(solver(face).u, -solver(mirror).u);
    };
    check(TwoRarefactionRiemann{});
    check(AcousticRiemann{});
}

} // namespace
} // namespace sph

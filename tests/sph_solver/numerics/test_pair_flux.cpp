// SPDX-License-Identifier: MIT
#include "sph_solver/numerics/pair_flux.hpp"
#include "tests/sph_solver/support/noise.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace sph {
namespace {

const Tait tait{1000.0, 30.0};

template<int D> PrimitiveState<D> random_state(sample::Noise& noise)
{
    PrimitiveState<D> state;
    state.density = 1000.0 * (1 + 0.01 * noise());
    for (int a = 0; a < D; ++a) {
        state.velocity[a] = 2 * noise();
        state.density_gradient[a] = 500 * noise();
        for (int b = 0; b < D; ++b) state.velocity_gradient(a, b) = 100 * noise();
    }
    return state;
}

template<int D> Vec<D> random_vector(sample::Noise& noise, double size)
{
    Vec<D> x;
    for (int a = 0; a < D; ++a) x[a] = size * noise();
    return x;
}

template<int D, class Limiter> void expect_opposite_fluxes(Limiter limiter)
{
    sample::Noise noise(11);
    for (int k = 0; k < 500; ++k) {
        const auto i = random_state<D>(noise), j = random_state<D>(noise);
        const Vec<D> x_ij = random_vector<D>(noise, 0.01);
        const auto seen_by_i = pair_flux<D>(i, j, x_ij, tait, limiter, false);
        const auto seen_by_j = pair_flux<D>(j, i, Vec<D>(-x_ij), tait, limiter, false);
        EXPECT_EQ(seen_by_i.mass_flux, -seen_by_j.mass_flux);
        EXPECT_EQ(seen_by_i.pressure, seen_by_j.pressure);
        EXPECT_EQ(seen_by_i.momentum_flux, -seen_by_j.momentum_flux);
    }
}

TEST(PairFlux, IsExactlyOppositeFromTheOtherSide)
{
    expect_opposite_fluxes<2>(VanAlbada{});
    expect_opposite_fluxes<3>(VanAlbada{});
    expect_opposite_fluxes<2>(Unlimited{});
    expect_opposite_fluxes<3>(Unlimited{});
    expect_opposite_fluxes<3>(FirstOrder{});
}

TEST(PairFlux, FluidInUniformMotionOnlyPushes)
{
    PrimitiveState<3> state;
    state.density = 1003.0;
    state.velocity = {1.5, -2.0, 0.25};
    const auto flux = pair_flux<3>(state, state, Vec<3>(0.01, 0.003, -0.002), tait, VanAlbada{}, false);
    EXPECT_NEAR(flux.pressure, tait.pressure(1003.0), 1e-8);
    EXPECT_EQ(flux.mass_flux, 0.0);
    EXPECT_EQ(flux.momentum_flux.norm(), 0.0);
}

TEST(PairFlux, LinearFieldIsReconstructedWithoutJump)
{
    // Both sides extrapolate the same linear field to the middle: no Riemann jump is left, the pressure is that of
    // the middle.
    PrimitiveState<2> i, j;
    const Vec<2> x_ij(0.004, -0.003);
    i.density_gradient = j.density_gradient = Vec<2>(200.0, 900.0);
    i.velocity_gradient << 3.0, 1.0, -2.0, -3.0;
    j.velocity_gradient = i.velocity_gradient;
    i.density = 1001.0;
    i.velocity = {0.5, 0.1};
    j.density = i.density + i.density_gradient.dot(x_ij);
    j.velocity = i.velocity + i.velocity_gradient * x_ij;
    const auto flux = pair_flux<2>(i, j, x_ij, tait, VanAlbada{}, false);
    EXPECT_NEAR(flux.pressure, tait.pressure(0.5 * (i.density + j.density)), 1e-7);
    EXPECT_NEAR(flux.mass_flux, 0.0, 1e-10);
}

TEST(PairFlux, TurnsWithTheFrame)
{
    sample::Noise noise(5);
    const Mat<3> turn = Eigen::AngleAxisd(0.7, Vec<3>(1, 2, -0.5).normalized()).toRotationMatrix();
    for (int k = 0; k < 100; ++k) {
        auto i = random_state<3>(noise), j = random_state<3>(noise);
        const Vec<3> x_ij = random_vector<3>(noise, 0.01);
        const auto flux = pair_flux<3>(i, j, x_ij, tait, VanAlbada{}, false);
        for (auto* state : {&i, &j}) {
            state->velocity = turn * state->velocity;
            state->density_gradient = turn * state->density_gradient;
            state->velocity_gradient = turn * state->velocity_gradient * turn.transpose();
        }
        const auto turned = pair_flux<3>(i, j, Vec<3>(turn * x_ij), tait, VanAlbada{}, false);
        EXPECT_NEAR(turned.pressure, flux.pressure, 1e-6);
        EXPECT_NEAR(turned.mass_flux, flux.mass_flux, 1e-8 * std::abs(flux.mass_flux) + 1e-8);
        EXPECT_LT((turned.momentum_flux - turn * flux.momentum_flux).norm(), 1e-7);
    }
}

TEST(PairFlux, PlaneFlowIsTheSameIn2DAnd3D)
{
    sample::Noise noise(6);
    for (int k = 0; k < 100; ++k) {
        const auto i = random_state<2>(noise), j = random_state<2>(noise);
        const Vec<2> x_ij = random_vector<2>(noise, 0.01);
        const auto lift = [](const PrimitiveState<2>& plane) {
            PrimitiveState<3> state;
            state.density = plane.density;
            state.velocity.head<2>() = plane.velocity;
            state.density_gradient.head<2>() = plane.density_gradient;
            state.velocity_gradient.topLeftCorner<2, 2>() = plane.velocity_gradient;
            return state;
        };
        const auto flat = pair_flux<2>(i, j, x_ij, tait, VanAlbada{}, false);
        const auto deep = pair_flux<3>(lift(i), lift(j), Vec<3>(x_ij[0], x_ij[1], 0.0), tait, VanAlbada{}, false);
        EXPECT_DOUBLE_EQ(deep.pressure, flat.pressure);
        EXPECT_LT((deep.momentum_flux.head<2>() - flat.momentum_flux).norm(), 1e-12 * flat.momentum_flux.norm());
    }
}

TEST(PairFlux, MassCarriesTheTangentialVelocityOfTheSideItLeaves)
{
    PrimitiveState<2> i, j;
    i.density = 1002.0; // presses towards j, along x
    j.density = 1000.0;
    i.velocity = {0.0, 3.0};
    j.velocity = {0.0, -1.0};
    const auto flux = pair_flux<2>(i, j, Vec<2>(0.01, 0.0), tait, FirstOrder{}, false);
    EXPECT_GT(flux.mass_flux, 0.0);
    EXPECT_DOUBLE_EQ(flux.momentum_flux[1], 3.0 * flux.mass_flux);
}

TEST(PairFlux, NothingPassesAWall)
{
    sample::Noise noise(8);
    const auto i = random_state<2>(noise), j = random_state<2>(noise);
    const Vec<2> x_ij(0.01, 0.002);
    const auto wall = pair_flux<2>(i, j, x_ij, tait, VanAlbada{}, true);
    EXPECT_EQ(wall.mass_flux, 0.0);
    EXPECT_EQ(wall.momentum_flux.norm(), 0.0);
    EXPECT_EQ(wall.pressure, pair_flux<2>(i, j, x_ij, tait, VanAlbada{}, false).pressure);
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/operators/fluid_flux.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/numerics/pair_flux.hpp"
#include "sph_solver/operators/derived_fields.hpp"
#include "sph_solver/operators/fluid_gradients.hpp"
#include "tests/sph_solver/support/reached_neighbours.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using sample::dx;

/// A jittered lattice in rough motion, with one evaluation of the fluid's operators.
template<int D> struct RoughFlow {
    explicit RoughFlow(const Limiter& limiter, int owned_share = 1)
        : model{CubicSpline<D>(1.23 * dx), Tait{1000.0, 30.0}, limiter, Vec<D>::Zero()},
          particles(sample::jittered_lattice<D>(D == 2 ? 11 : 6, dx, 0.2, 1000.0))
    {
        sample::Noise noise(21);
        for (std::size_t i = 0; i < particles.size(); ++i) {
            particles.mass[i] *= 1 + 0.01 * noise();
            for (int a = 0; a < D; ++a) particles.momentum[i][a] = particles.mass[i] * noise();
        }
        evaluate_gradients();
        records.load_slopes(particles, model, particles.owned);
        if (owned_share > 1) keep_every(owned_share);
        rates.reset(particles.size());
        add_fluid_fluid_flux(rates, fluxes, records, neighbours, particles.owned, model);
    }

    void evaluate_gradients()
    {
        update_derived(particles, model.eos);
        records.load_states(particles, model.eos, particles.owned);
        neighbours = sample::reached_neighbours(particles, model.kernel.support());
        accumulate_fluid_gradients(sums, records, neighbours, particles.owned, model);
        finish_gradients(particles, sums, model);
    }

    /// Hands all but every n-th particle to somebody else: they stay as halo copies.
    void keep_every(int n)
    {
        std::erase_if(particles.owned, [n](int i) { return i % n != 0; });
        neighbours = sample::reached_neighbours(particles, model.kernel.support());
    }

    FluidModel<D> model;
    Particles<D> particles;
    PairRecords<D> records;
    sample::HeldNeighbours neighbours;
    GradientField<D> sums;
    FluxField<D> fluxes;
    Rates<D> rates;
};

template<int D, class AnyLimiter> FluxSums<D> plain_sum(const RoughFlow<D>& flow, std::size_t i, AnyLimiter limiter)
{
    const Particles<D>& p = flow.particles;
    const auto state = [&p](std::size_t k) {
        return PrimitiveState<D>{p.density[k], p.velocity[k], p.density_gradient[k], p.velocity_gradient[k]};
    };
    FluxSums<D> sum;
    for (const int neighbour : flow.neighbours.of(i)) {
        const auto j = static_cast<std::size_t>(neighbour);
        const Vec<D> x_ij = p.position[j] - p.position[i];
        const double area = 2 * p.volume[i] * p.volume[j] * flow.model.kernel.slope(x_ij.norm());
        const auto flux = pair_flux<D>(state(i), state(j), x_ij, flow.model.eos, limiter, false);
        sum.mass -= area * flux.mass_flux;
        sum.by_mass -= area * flux.momentum_flux;
        sum.by_pressure -= area * flux.pressure * x_ij.normalized();
        sum.dilation += 0.5 * area * (p.velocity[j] - p.velocity[i]).dot(x_ij.normalized());
        sum.swept += area * flux.mass_flux / flow.model.eos.density(flux.pressure); // S u
    }
    return sum;
}

template<int D, class AnyLimiter> void expect_plain_sums(AnyLimiter limiter)
{
    const RoughFlow<D> flow(limiter);
    double scale = 0;
    for (const auto& flux : flow.fluxes) scale = std::max(scale, flux.by_pressure.norm());
    for (std::size_t i = 0; i < flow.particles.size(); ++i) {
        const auto expected = plain_sum(flow, i, limiter);
        EXPECT_NEAR(flow.fluxes[i].mass, expected.mass, 1e-12 * scale);
        EXPECT_LT((flow.fluxes[i].by_mass - expected.by_mass).norm(), 1e-12 * scale);
        EXPECT_LT((flow.fluxes[i].by_pressure - expected.by_pressure).norm(), 1e-12 * scale);
        EXPECT_NEAR(flow.fluxes[i].dilation, expected.dilation, 1e-12 * flow.particles.volume[i] / dx);
        EXPECT_EQ(flow.rates.mass[i], flow.fluxes[i].mass);
        EXPECT_EQ(flow.rates.volume[i], flow.fluxes[i].dilation);
    }
}

TEST(FluidFlux, PackedLoopsGiveThePlainSum)
{
    expect_plain_sums<2>(VanAlbada{});
    expect_plain_sums<3>(VanAlbada{});
    expect_plain_sums<2>(Unlimited{});
    expect_plain_sums<3>(FirstOrder{});
}

template<int D> void expect_conservation()
{
    const RoughFlow<D> flow(VanAlbada{});
    double mass = 0, mass_scale = 0, force_scale = 0;
    Vec<D> force = Vec<D>::Zero();
    for (std::size_t i = 0; i < flow.particles.size(); ++i) {
        mass += flow.rates.mass[i];
        force += flow.rates.momentum[i];
        mass_scale += std::abs(flow.rates.mass[i]);
        force_scale += flow.rates.momentum[i].norm();
    }
    EXPECT_GT(mass_scale, 0.0);
    EXPECT_LT(std::abs(mass), 1e-14 * mass_scale);
    EXPECT_LT(force.norm(), 1e-14 * force_scale);
}

TEST(FluidFlux, ConservesMassAndMomentum)
{
    expect_conservation<2>();
    expect_conservation<3>();
}

template<int D> void expect_same_bits_as_halo()
{
    const RoughFlow<D> whole(VanAlbada{}), part(VanAlbada{}, 3);
    ASSERT_LT(part.particles.owned.size(), whole.particles.owned.size());
    for (const int owned : part.particles.owned) {
        const auto i = static_cast<std::size_t>(owned);
        EXPECT_EQ(part.rates.mass[i], whole.rates.mass[i]);
        EXPECT_EQ(part.rates.momentum[i], whole.rates.momentum[i]);
    }
}

TEST(FluidFlux, DoesNotDependOnWhoOwnsTheNeighbours)
{
    expect_same_bits_as_halo<2>();
    expect_same_bits_as_halo<3>();
}

TEST(FluidFlux, FacesThatMoveWithTheFluidSweepVolumeAndPassNoMass)
{
    RoughFlow<2> flow(VanAlbada{});
    const auto with_mass = flow.fluxes; // their dilation is what the particles' own motion opens
    flow.model.face_motion = FluidMotion{};
    flow.rates.reset(flow.particles.size());
    add_fluid_fluid_flux(flow.rates, flow.fluxes, flow.records, flow.neighbours, RowSet(flow.particles.owned),
                         flow.model);
    double volume = 0, scale = 0;
    for (std::size_t i = 0; i < flow.particles.size(); ++i) {
        const double expected = plain_sum(flow, i, VanAlbada{}).swept;
        const double swept = flow.fluxes[i].dilation - with_mass[i].dilation;
        EXPECT_NEAR(swept, expected, 1e-9 * std::abs(expected) + 1e-15);
        EXPECT_EQ(flow.fluxes[i].mass, 0.0);
        EXPECT_EQ(flow.fluxes[i].by_mass, Vec<2>::Zero().eval());
        EXPECT_EQ(flow.fluxes[i].by_pressure, with_mass[i].by_pressure);
        EXPECT_EQ(flow.rates.volume[i], flow.fluxes[i].dilation);
        volume += swept;
        scale += std::abs(swept);
    }
    EXPECT_GT(scale, 0.0);
    EXPECT_NEAR(volume, 0.0, 1e-13 * scale); // what one particle gains the other loses
}

TEST(FluidFlux, SkinOfTheListAddsNothing)
{
    RoughFlow<2> flow(VanAlbada{});
    const Rates<2> before = flow.rates;
    flow.neighbours = sample::reached_neighbours(flow.particles, flow.model.kernel.support());
    flow.rates.reset(flow.particles.size());
    add_fluid_fluid_flux(flow.rates, flow.fluxes, flow.records, flow.neighbours, RowSet(flow.particles.owned),
                         flow.model);
    for (std::size_t i = 0; i < flow.particles.size(); ++i)
        EXPECT_LT((flow.rates.momentum[i] - before.momentum[i]).norm(), 1e-12 * before.momentum[i].norm());
}

TEST(Gravity, IsTheWeight)
{
    const auto particles = sample::jittered_lattice<3>(2, dx, 0.0, 1000.0);
    Rates<3> rates;
    rates.reset(particles.size());
    add_gravity<3>(rates, particles, Vec<3>(0, 0, -9.81));
    EXPECT_DOUBLE_EQ(rates.momentum[5][2], -9.81 * 1000.0 * dx * dx * dx);
}

TEST(DerivedFields, FollowFromTheConservedOnes)
{
    auto particles = sample::jittered_lattice<2>(2, dx, 0.0, 1010.0);
    particles.momentum[1] = Vec<2>(1.0, -2.0) * particles.mass[1];
    update_derived(particles, Tait{1000.0, 30.0});
    EXPECT_NEAR((particles.velocity[1] - Vec<2>(1.0, -2.0)).norm(), 0.0, 1e-14);
    EXPECT_NEAR(particles.density[1], 1010.0, 1e-10);
    EXPECT_NEAR(particles.pressure[1], (Tait{1000.0, 30.0}.pressure(1010.0)), 1e-6);
    EXPECT_NEAR(particles.sound_speed[1], 30.0 * std::pow(1.01, 3), 1e-10);
}

TEST(DerivedFields, NameTheParticleThatDiverged)
{
    auto particles = sample::jittered_lattice<2>(2, dx, 0.0, 1000.0);
    particles.momentum[3][0] = std::nan("");
    try {
        update_derived(particles, Tait{1000.0, 30.0});
        ADD_FAILURE() << "NaN went through";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::numerical_failure);
        EXPECT_NE(std::string(error.what()).find("particle 3"), std::string::npos) << error.what();
    }
    particles.momentum[3][0] = 0;
    particles.volume[2] = -1e-9;
    EXPECT_THROW(update_derived(particles, Tait{1000.0, 30.0}), base::Error);
}

} // namespace
} // namespace sph

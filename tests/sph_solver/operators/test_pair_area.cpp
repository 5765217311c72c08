// SPDX-License-Identifier: MIT
#include "sph_solver/operators/derived_fields.hpp"
#include "sph_solver/operators/fluid_flux.hpp"
#include "sph_solver/operators/fluid_gradients.hpp"
#include "tests/sph_solver/support/reached_neighbours.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using sample::dx;

/// A lattice that has been stretched along x and pressed along y, in a linear flow, evaluated on renormalised areas.
template<int D> struct StretchedFlow {
    explicit StretchedFlow(double jitter) : particles(sample::jittered_lattice<D>(14, dx, jitter, 1000.0))
    {
        slope = Mat<D>::Zero();
        slope(0, 0) = 2.0;
        slope(1, 1) = -0.5;
        slope(0, 1) = 1.0;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            particles.position[i][0] *= 1.1;
            particles.position[i][1] /= 1.1;
            particles.momentum[i] = particles.mass[i] * (slope * particles.position[i]);
        }
        update_derived(particles, model.eos, particles.owned);
        records.load_states(particles, model.eos, particles.owned);
        neighbours = sample::reached_neighbours(particles, model.kernel.support());
        accumulate_fluid_gradients(sums, records, neighbours, particles.owned, model);
        rates.reset(particles.size());
        finish_gradients(particles, sums, model);
        records.load_slopes(particles, model, particles.owned);
        add_fluid_fluid_flux(rates, fluxes, records, neighbours, particles.owned, model);
    }

    FluidModel<D> model{
        CubicSpline<D>(1.23 * dx), Tait{1000.0, 30.0}, VanAlbada{}, Vec<D>::Zero(), ExactRiemann{}, MeanMotion{},
        RenormalisedArea{}};
    Mat<D> slope;
    Particles<D> particles;
    PairRecords<D> records;
    sample::HeldNeighbours neighbours;
    GradientField<D> sums;
    FluxField<D> fluxes;
    Rates<D> rates;
};

template<int D> bool deep(const Particles<D>& particles, std::size_t i)
{
    for (int a = 0; a < D; ++a) {
        double low = 1e9, high = -1e9;
        for (const Vec<D>& x : particles.position) {
            low = std::min(low, x[a]);
            high = std::max(high, x[a]);
        }
        if (particles.position[i][a] < low + 5 * dx || particles.position[i][a] > high - 5 * dx) return false;
    }
    return true;
}

/// dw/dt = w div v where the neighbours are arranged alike, which raw gradients miss by what M is off.
template<int D> void expect_true_volumes()
{
    const StretchedFlow<D> flow(0.0);
    const double divergence = flow.slope.trace();
    std::size_t seen = 0;
    for (std::size_t i = 0; i < flow.particles.size(); ++i) {
        if (!deep<D>(flow.particles, i)) continue;
        ++seen;
        const double raw = flow.sums[i].velocity.trace(), found = flow.rates.volume[i] / flow.particles.volume[i];
        EXPECT_GT(std::abs(raw - divergence), 1e-3 * divergence);
        EXPECT_NEAR(found, divergence, 1e-9 * divergence);
    }
    EXPECT_GT(seen, 0U);
}

TEST(PairArea, KeepsVolumesTrueOnAStretchedLattice)
{
    expect_true_volumes<2>();
    expect_true_volumes<3>();
}

template<int D> void expect_areas_conserve()
{
    const StretchedFlow<D> flow(0.2);
    Vec<D> force = Vec<D>::Zero();
    double scale = 0, power = 0, power_scale = 0;
    for (std::size_t i = 0; i < flow.particles.size(); ++i) {
        force += flow.rates.momentum[i];
        scale += flow.rates.momentum[i].norm();
        EXPECT_EQ(flow.rates.volume[i], flow.fluxes[i].dilation);
        power += std::abs(flow.fluxes[i].dilation - flow.particles.volume[i] * flow.sums[i].velocity.trace());
        power_scale += flow.particles.volume[i];
    }
    EXPECT_LT(force.norm(), 1e-13 * scale);
    EXPECT_GT(power, 1e-6 * power_scale);
}

TEST(PairArea, KeepsMomentum)
{
    expect_areas_conserve<2>();
    expect_areas_conserve<3>();
}

/// The pressure force and the volumes' rates do opposite work: with one pressure p on all faces, sum v.F = p sum dw/dt.
TEST(PairArea, IsTheConjugateOfThePressureForce)
{
    StretchedFlow<2> flow(0.2);
    const double q = 1.01;
    for (std::size_t i = 0; i < flow.particles.size(); ++i) {
        flow.particles.mass[i] = q * 1000.0 * flow.particles.volume[i];
        flow.particles.momentum[i].setZero(); // no jump: every face has the particles' own pressure
    }
    update_derived(flow.particles, flow.model.eos, flow.particles.owned);
    for (auto& gradient : flow.particles.density_gradient) gradient.setZero();
    for (auto& gradient : flow.particles.velocity_gradient) gradient.setZero();
    flow.records.load_states(flow.particles, flow.model.eos, flow.particles.owned);
    flow.records.load_slopes(flow.particles, flow.model, flow.particles.owned);
    const auto moving = flow.fluxes;
    const auto rates = flow.rates;
    flow.rates.reset(flow.particles.size());
    add_fluid_fluid_flux(flow.rates, flow.fluxes, flow.records, flow.neighbours, flow.particles.owned, flow.model);
    const double p = flow.model.eos.pressure_at_ratio(q);
    double work = 0, dilation = 0;
    for (std::size_t i = 0; i < flow.particles.size(); ++i) {
        work += (flow.slope * flow.particles.position[i]).dot(flow.fluxes[i].by_pressure);
        dilation += rates.volume[i];
    }
    EXPECT_NEAR(work, p * dilation, 1e-9 * std::abs(p * dilation));
}

TEST(PairArea, GoesOverToRawAtFreeSurfaces)
{
    const RenormalisedArea area;
    Mat<2> moment = Mat<2>::Identity();
    moment(0, 0) = 0.7;
    EXPECT_EQ(area.renormaliser<2>(moment), Mat<2>::Identity());
    moment(0, 0) = 0.96;
    EXPECT_NEAR(area.renormaliser<2>(moment)(0, 0), 1.0 / 0.96, 1e-14);
    moment(0, 0) = 0.85;
    const double half = area.renormaliser<2>(moment)(0, 0);
    EXPECT_NEAR(half, 1.0 + 0.5 * (1.0 / 0.85 - 1.0), 1e-12);
    Mat<3> full = Mat<3>::Identity();
    full(0, 1) = full(1, 0) = 0.03;
    EXPECT_LT((area.renormaliser<3>(full) * full - Mat<3>::Identity()).norm(), 1e-12);
}

} // namespace
} // namespace sph

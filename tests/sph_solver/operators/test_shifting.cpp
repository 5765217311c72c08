// SPDX-License-Identifier: MIT
#include "sph_solver/operators/derived_fields.hpp"
#include "sph_solver/operators/fluid_flux.hpp"
#include "sph_solver/operators/fluid_gradients.hpp"
#include "sph_solver/operators/shifting.hpp"
#include "tests/sph_solver/support/reached_neighbours.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

using sample::dx;

/// A rough square or cube of water that moves with v = A x, evaluated up to its shifts.
template<int D> struct ShiftedFlow {
    explicit ShiftedFlow(const Mat<D>& velocity_slope)
        : particles(sample::jittered_lattice<D>(D == 2 ? 13 : 9, dx, 0.2, 1000.0))
    {
        for (std::size_t i = 0; i < particles.size(); ++i)
            particles.momentum[i] = particles.mass[i] * (velocity_slope * particles.position[i]);
        update_derived(particles, model.eos, particles.owned);
        records.load_states(particles, model.eos, particles.owned);
        neighbours = sample::reached_neighbours(particles, model.kernel.support());
        accumulate_fluid_gradients(sums, records, neighbours, particles.owned, model);
        rates.reset(particles.size());
        finish_gradients(particles, sums, model);
        find_shifts(particles, records, neighbours, sums, walls, model);
    }

    FluidModel<D> model{
        CubicSpline<D>(1.23 * dx), Tait{1000.0, 30.0}, VanAlbada{}, Vec<D>::Zero(), ExactRiemann{}, ShiftedMotion{}};
    Walls<D> walls{WallSettings<D>{}};
    Particles<D> particles;
    PairRecords<D> records;
    sample::HeldNeighbours neighbours;
    GradientField<D> sums;
    FluxField<D> fluxes;
    Rates<D> rates;
};

template<int D> Mat<D> shear()
{
    Mat<D> slope = Mat<D>::Zero();
    slope(0, 1) = 2.0;
    return slope;
}

template<int D> void expect_shifts_conserve()
{
    ShiftedFlow<D> flow(shear<D>());
    flow.records.load_slopes(flow.particles, flow.model, flow.particles.owned);
    add_fluid_fluid_flux(flow.rates, flow.fluxes, flow.records, flow.neighbours, flow.particles.owned, flow.model);
    double mass = 0, mass_scale = 0, swept_scale = 0;
    Vec<D> force = Vec<D>::Zero();
    double force_scale = 0, shift_scale = 0;
    for (std::size_t i = 0; i < flow.particles.size(); ++i) {
        mass += flow.rates.mass[i];
        mass_scale += std::abs(flow.rates.mass[i]);
        force += flow.rates.momentum[i];
        force_scale += flow.rates.momentum[i].norm();
        swept_scale += std::abs(flow.fluxes[i].swept);
        shift_scale += flow.particles.shift[i].norm();
    }
    EXPECT_GT(shift_scale, 0.0);
    EXPECT_GT(swept_scale, 0.0);
    EXPECT_LT(std::abs(mass), 1e-13 * mass_scale);
    EXPECT_LT(force.norm(), 1e-13 * force_scale);
}

TEST(Shifting, KeepsMassAndMomentum)
{
    expect_shifts_conserve<2>();
    expect_shifts_conserve<3>();
}

TEST(Shifting, IsGoneInRigidMotion)
{
    Mat<2> turn = Mat<2>::Zero();
    turn(0, 1) = -3.0;
    turn(1, 0) = 3.0;
    const ShiftedFlow<2> turning(turn), sheared(shear<2>());
    for (std::size_t i = 0; i < turning.particles.size(); ++i)
        EXPECT_LE(turning.particles.shift[i].norm(), 1e-9 * (1.0 + sheared.particles.shift[i].norm()));
}

TEST(Shifting, LeavesTheFreeSurfaceAlone)
{
    const ShiftedFlow<2> flow(shear<2>());
    std::size_t moved = 0;
    for (std::size_t i = 0; i < flow.particles.size(); ++i) {
        const Vec<2>& x = flow.particles.position[i];
        const double depth = std::min(x.minCoeff(), 13 * dx - x.maxCoeff());
        if (depth < dx) {
            EXPECT_EQ(flow.particles.shift[i].norm(), 0.0);
        }
        moved += flow.particles.shift[i].norm() > 0.0 ? 1 : 0;
    }
    EXPECT_GT(moved, flow.particles.size() / 3);
}

/// One particle out of its place goes back: the shift points against its displacement.
TEST(Shifting, PointsToWhereThereIsRoom)
{
    ShiftedFlow<2> flow(shear<2>());
    auto lattice = sample::jittered_lattice<2>(13, dx, 0.0, 1000.0);
    const std::size_t middle = 6 * 13 + 6;
    flow.particles.position = lattice.position;
    flow.particles.position[middle] += Vec<2>(0.2 * dx, -0.1 * dx);
    flow.records.load_states(flow.particles, flow.model.eos, flow.particles.owned);
    flow.neighbours = sample::reached_neighbours(flow.particles, flow.model.kernel.support());
    accumulate_fluid_gradients(flow.sums, flow.records, flow.neighbours, flow.particles.owned, flow.model);
    find_shifts(flow.particles, flow.records, flow.neighbours, flow.sums, flow.walls, flow.model);
    const Vec<2> shift = flow.particles.shift[middle];
    EXPECT_GT(-shift.dot(Vec<2>(2, -1).normalized()), 0.9 * shift.norm());
}

} // namespace
} // namespace sph

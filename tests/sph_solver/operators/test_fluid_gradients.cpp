// SPDX-License-Identifier: MIT
#include "sph_solver/numerics/eigenvalues.hpp"
#include "sph_solver/operators/fluid_gradients.hpp"

#include "sph_solver/operators/derived_fields.hpp"
#include "tests/sph_solver/support/reached_neighbours.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace sph {
namespace {

using sample::dx;

template<int D> FluidModel<D> model()
{
    return {CubicSpline<D>(1.23 * dx), Tait{1000.0, 30.0}, VanAlbada{}, Vec<D>::Zero()};
}

/// A jittered lattice with linear density and velocity; returns the particles with gradients, and the sums behind them.
template<int D> struct LinearFlow {
    LinearFlow(const Vec<D>& density_slope, const Mat<D>& velocity_slope)
        : particles(sample::jittered_lattice<D>(D == 2 ? 12 : 8, dx, 0.15, 1000.0))
    {
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const Vec<D>& x = particles.position[i];
            particles.mass[i] = (1000.0 + density_slope.dot(x)) * particles.volume[i];
            particles.momentum[i] = particles.mass[i] * (velocity_slope * x + Vec<D>::Constant(3.0));
        }
        update_derived(particles, model<D>().eos);
        records.load_states(particles, model<D>().eos, particles.owned);
        neighbours = sample::reached_neighbours(particles, model<D>().kernel.support());
        accumulate_fluid_gradients(sums, records, neighbours, particles.owned, model<D>());
        finish_gradients(particles, sums, model<D>());
    }

    Particles<D> particles;
    PairRecords<D> records;
    sample::HeldNeighbours neighbours;
    GradientField<D> sums;
};

template<int D> void expect_linear_fields_exact()
{
    Vec<D> density_slope;
    Mat<D> velocity_slope;
    for (int a = 0; a < D; ++a) {
        density_slope[a] = 100.0 - 70.0 * a;
        for (int b = 0; b < D; ++b) velocity_slope(a, b) = 1.0 + 2.0 * a - 3.0 * b;
    }
    const LinearFlow<D> flow(density_slope, velocity_slope);
    std::size_t inverted = 0;
    for (std::size_t i = 0; i < flow.particles.size(); ++i) {
        if (flow.sums[i].fluid_fill < thread_fill) continue;
        if (!eigenvalues_exceed<D>(flow.sums[i].moment, least_eigenvalue)) continue;
        ++inverted;
        EXPECT_LT((flow.particles.density_gradient[i] - density_slope).norm(), 1e-7) << i;
        EXPECT_LT((flow.particles.velocity_gradient[i] - velocity_slope).norm(), 1e-10) << i;
    }
    EXPECT_GT(inverted,
              flow.particles.size() * 9 / 10); // faces and edges included: a half space has an eigenvalue near 0.5
}

TEST(FluidGradients, AreExactForLinearFields2D) { expect_linear_fields_exact<2>(); }
TEST(FluidGradients, AreExactForLinearFields3D) { expect_linear_fields_exact<3>(); }

TEST(FluidGradients, SumsAreThoseOfThePlainFormula)
{
    Mat<2> velocity_slope;
    velocity_slope << 0.5, 1.0, -2.0, 0.25;
    const LinearFlow<2> flow(Vec<2>(40.0, -20.0), velocity_slope);
    const Particles<2>& p = flow.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        Mat<2> moment = Mat<2>::Zero();
        for (const int neighbour : flow.neighbours.of(i)) {
            const auto j = static_cast<std::size_t>(neighbour);
            const Vec<2> x_ij = p.position[j] - p.position[i];
            const Vec<2> gradient = -model<2>().kernel.derivative(x_ij.norm()) * x_ij.normalized();
            moment += p.volume[j] * x_ij * gradient.transpose();
        }
        EXPECT_LT((flow.sums[i].moment - moment).norm(), 1e-13);
    }
}

TEST(FluidGradients, FullNeighbourhoodHasTheUnitMoment)
{
    const LinearFlow<2> flow(Vec<2>::Zero(), Mat<2>::Zero());
    const std::size_t centre = 5 * 12 + 5;
    EXPECT_LT((flow.sums[centre].moment - Mat<2>::Identity()).norm(), 0.1);
}

/// Four particles in shear, with sums of the first that are given.
Mat<2> gradient_of_four(double eigenvalue, double fill, GradientSums<2>& sum)
{
    Particles<2> four = sample::jittered_lattice<2>(2, dx, 0.0, 1000.0);
    for (std::size_t i = 0; i < 4; ++i) four.momentum[i][0] = four.mass[i] * static_cast<double>(i);
    update_derived(four, model<2>().eos);
    PairRecords<2> records;
    records.load_states(four, model<2>().eos, four.owned);
    GradientField<2> sums;
    accumulate_fluid_gradients(sums, records, sample::reached_neighbours(four, 1.2 * dx), four.owned, model<2>());
    EXPECT_LT(sums[0].fluid_fill, thread_fill);
    sums[0].moment = eigenvalue * Mat<2>::Identity();
    sums[0].fluid_fill = fill;
    finish_gradients(four, sums, model<2>());
    sum = sums[0];
    return four.velocity_gradient[0];
}

TEST(FluidGradients, UseTheRawSumsWhereTheMomentIsPoor)
{
    GradientSums<2> sum;
    EXPECT_EQ(gradient_of_four(0.19, 0.5, sum), sum.velocity);
}

TEST(FluidGradients, AreZeroInThreadsAndDrops)
{
    GradientSums<2> sum;
    EXPECT_EQ(gradient_of_four(0.5, 0.33, sum), Mat<2>::Zero());
    EXPECT_GT(sum.velocity.norm(), 0.0);
}

template<int D> void expect_minors_agree_with_eigenvalues()
{
    sample::Noise noise(3);
    for (int k = 0; k < 2000; ++k) {
        Mat<D> a;
        for (int r = 0; r < D; ++r)
            for (int c = 0; c < D; ++c) a(r, c) = noise();
        const Mat<D> moment = a * a.transpose();
        const double smallest = Eigen::SelfAdjointEigenSolver<Mat<D>>(moment).eigenvalues()[0];
        EXPECT_EQ(eigenvalues_exceed<D>(moment, least_eigenvalue), smallest > 0.2) << smallest;
    }
}

TEST(FluidGradients, ConditionIsTheSmallestEigenvalue)
{
    expect_minors_agree_with_eigenvalues<2>();
    expect_minors_agree_with_eigenvalues<3>();
}

TEST(FluidGradients, LoneParticleHasNone)
{
    Particles<3> lone = sample::jittered_lattice<3>(1, dx, 0.0, 1000.0);
    update_derived(lone, model<3>().eos);
    PairRecords<3> records;
    records.load_states(lone, model<3>().eos, lone.owned);
    GradientField<3> sums;
    accumulate_fluid_gradients(sums, records, sample::reached_neighbours(lone, 1.0), lone.owned, model<3>());
    EXPECT_EQ(sums[0].moment.norm() + sums[0].velocity.norm() + sums[0].density.norm(), 0.0);
}

} // namespace
} // namespace sph

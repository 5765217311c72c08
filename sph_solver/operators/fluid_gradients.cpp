// SPDX-License-Identifier: MIT
#include "sph_solver/operators/fluid_gradients.hpp"

#include <Eigen/LU>

namespace sph {
namespace {

/// The same sums as GradientSums, neighbours side by side: the upper triangle of M, then G[v] row by row, then G[q].
template<int D> struct PackedSums {
    static constexpr std::size_t velocity = D * (D + 1) / 2, ratio = velocity + D * D;
    static constexpr std::size_t count = ratio + D;

    /// Place of M(a, b), a <= b, in its upper triangle row by row.
    static constexpr std::size_t upper_triangle(std::size_t a, std::size_t b) { return a * D - a * (a + 1) / 2 + b; }

    /// Adds the neighbours of a pack, given as columns (x, v, q, w), to the sums of particle i.
    [[gnu::always_inline]] static inline void add(std::array<Pack, count>& sums, const std::array<Pack, 8>& neighbour,
                                                  const double* state, const CubicSpline<D>& kernel)
    {
        std::array<Pack, D> x, weighted;
        unrolled<D>([&](auto a) __attribute__((always_inline)) { x[a] = neighbour[a] - state[a]; });
        const Pack r = square_root(dot(x, x) + 1e-300);
        const Pack weight = neighbour[2 * D + 1] * (kernel.slope(r) / r);
        unrolled<D>([&](auto a) __attribute__((always_inline)) { weighted[a] = weight * x[a]; });

        const Pack ratio_jump = neighbour[2 * D] - state[2 * D];
        unrolled<D>([&](auto a) __attribute__((always_inline)) {
            const Pack velocity_jump = neighbour[D + a] - state[D + a];
            sums[ratio + a] = multiply_add(ratio_jump, weighted[a], sums[ratio + a]);
            unrolled<D>([&](auto b) __attribute__((always_inline)) {
                constexpr std::size_t ab = upper_triangle(a, b), ab_v = velocity + a * D + b;
                if constexpr (b >= a) sums[ab] = multiply_add(x[a], weighted[b], sums[ab]);
                sums[ab_v] = multiply_add(velocity_jump, weighted[b], sums[ab_v]);
            });
        });
    }

    static void write(GradientSums<D>& result, const PartSums<count>& parts, double rho0)
    {
        const auto total = sum_lanes_of(parts);
        std::size_t ab = 0, ab_v = velocity;
        for (int a = 0; a < D; ++a) {
            for (int b = a; b < D; ++b, ++ab) result.moment(a, b) = result.moment(b, a) = total[ab];
            for (int b = 0; b < D; ++b, ++ab_v) result.velocity(a, b) = total[ab_v];
            result.density[a] = rho0 * total[ratio + static_cast<std::size_t>(a)];
        }
        result.fluid_divergence = result.divergence();
        result.fluid_fill = result.moment.trace() / D;
    }
};

} // namespace

template<int D>
void accumulate_fluid_gradients(GradientField<D>& sums, const PairRecords<D>& records,
                                const ReachedNeighbours& neighbours, const RowSet& rows, const FluidModel<D>& model)
{
    const auto state_of = [&](int j) { return records.state(j); };
    const CubicSpline<D> kernel = model.kernel;
    sums.resize(rows.all());
    rows.for_each([&](std::size_t k, int i) {
        const double* state = records.state(i);
        const auto row = neighbours.packs_of(k);
        PartSums<PackedSums<D>::count> parts{};
        for_each_part(
            row.size(), [&](auto part, std::size_t n) __attribute__((always_inline)) {
                PackedSums<D>::add(parts[part], load_columns<8>(state_of, &row[n]), state, kernel);
            });
        PackedSums<D>::write(sums[k], parts, model.eos.rho0);
    });
}

template<int D> bool eigenvalues_exceed(const Mat<D>& moment, double limit)
{
    const Mat<D> shifted = moment - limit * Mat<D>::Identity();
    bool positive = shifted(0, 0) > 0.0 && shifted.template topLeftCorner<2, 2>().determinant() > 0.0;
    if constexpr (D == 3) positive = positive && shifted.determinant() > 0.0;
    return positive;
}

template<int D>
void finish_gradients(Particles<D>& particles, Rates<D>& rates, const GradientField<D>& sums,
                      const FluidModel<D>& model)
{
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const auto i = static_cast<std::size_t>(particles.owned[k]);
        const GradientSums<D>& sum = sums[k];
        std::visit([&](auto area) { particles.renormaliser[i] = area.template renormaliser<D>(sum.moment); },
                   model.pair_area);
        rates.volume[i] = particles.volume[i] * sum.divergence();
        particles.density_gradient[i] = sum.density;
        particles.velocity_gradient[i] = sum.velocity;
        if (sum.fluid_fill < thread_fill) {
            particles.density_gradient[i].setZero();
            particles.velocity_gradient[i].setZero();
        } else if (eigenvalues_exceed<D>(sum.moment, least_eigenvalue)) {
            const Mat<D> inverse = sum.moment.inverse();
            particles.density_gradient[i] = inverse * sum.density;
            particles.velocity_gradient[i] = sum.velocity * inverse;
        }
    }
}

template bool eigenvalues_exceed<2>(const Mat<2>&, double);
template bool eigenvalues_exceed<3>(const Mat<3>&, double);
template void accumulate_fluid_gradients<2>(GradientField<2>&, const PairRecords<2>&, const ReachedNeighbours&,
                                            const RowSet&, const FluidModel<2>&);
template void accumulate_fluid_gradients<3>(GradientField<3>&, const PairRecords<3>&, const ReachedNeighbours&,
                                            const RowSet&, const FluidModel<3>&);
template void finish_gradients<2>(Particles<2>&, Rates<2>&, const GradientField<2>&, const FluidModel<2>&);
template void finish_gradients<3>(Particles<3>&, Rates<3>&, const GradientField<3>&, const FluidModel<3>&);

} // namespace sph

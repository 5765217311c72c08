// SPDX-License-Identifier: MIT
#include "sph_solver/operators/fluid_gradients.hpp"

#include "sph_solver/numerics/eigenvalues.hpp"

#include <Eigen/LU>

namespace sph {
namespace {

/// The same sums as GradientSums, neighbours side by side: the upper triangle of M, then G[v] row by row, then G[q].
template<int D> struct PackedSums {
    static constexpr std::size_t velocity = D * (D + 1) / 2, ratio = velocity + D * D;
    static constexpr std::size_t count = ratio + D;

    static void write(GradientSums<D>& result, const PartSums<count>& parts, double rho0)
    {
        const auto total = sum_lanes_of(parts);
        std::size_t ab = 0, ab_v = velocity;
        for (int a = 0; a < D; ++a) {
            for (int b = a; b < D; ++b, ++ab) result.moment(a, b) = result.moment(b, a) = total[ab];
            for (int b = 0; b < D; ++b, ++ab_v) result.velocity(a, b) = total[ab_v];
            result.density[a] = rho0 * total[ratio + static_cast<std::size_t>(a)];
        }
        result.fluid_fill = result.moment.trace() / D;
    }
};

/// A pack of neighbours of one particle, as the first loop leaves it to the second.
template<int D> struct Differences {
    std::array<Pack, D> x, velocity; ///< x_j - x_i, v_j - v_i
    Pack ratio;                      ///< q_j - q_i
    Pack weight;                     ///< w_j |W'| / r

    /// \param neighbour columns (x, v, q, w)
    [[gnu::always_inline]] inline void find(const std::array<Pack, 8>& neighbour, const double* state,
                                            const CubicSpline<D>& kernel)
    {
        unrolled<D>([&](auto a) __attribute__((always_inline)) {
            x[a] = neighbour[a] - state[a];
            velocity[a] = neighbour[D + a] - state[D + a];
        });
        ratio = neighbour[2 * D] - state[2 * D];
        const Pack r = square_root(dot(x, x) + 1e-300);
        weight = neighbour[2 * D + 1] * (kernel.slope(r) / r);
    }

    [[gnu::always_inline]] inline void add_to(std::array<Pack, PackedSums<D>::count>& sums) const
    {
        using At = PackedSums<D>;
        std::array<Pack, D> weighted;
        unrolled<D>([&](auto a) __attribute__((always_inline)) { weighted[a] = weight * x[a]; });
        unrolled<D>([&](auto a) __attribute__((always_inline)) {
            sums[At::ratio + a] = multiply_add(ratio, weighted[a], sums[At::ratio + a]);
            unrolled<D>([&](auto b) __attribute__((always_inline)) {
                constexpr std::size_t ab = upper_triangle<D>(a, b), ab_v = At::velocity + a * D + b;
                if constexpr (b >= a) sums[ab] = multiply_add(x[a], weighted[b], sums[ab]);
                sums[ab_v] = multiply_add(velocity[a], weighted[b], sums[ab_v]);
            });
        });
    }
};

/// The work in two loops over a batch of rows: the root and the division of the first take so long that a processor overlaps
/// packs enough only where little else waits for them.
template<int D> class GradientBatch {
public:
    GradientBatch(GradientField<D>& sums, const PairRecords<D>& records, const ReachedNeighbours& neighbours,
                  const FluidModel<D>& model)
        : sums_(sums),
          records_(records),
          neighbours_(neighbours),
          model_(model),
          others_(filled + neighbours.longest() + row_overhang),
          packs_(others_.size() / pack_lanes)
    {}

    /// Takes row k, of particle i: whole packs of its neighbours.
    void add(std::size_t k, int i)
    {
        const std::size_t length = neighbours_.unfold(k, i, &others_[size_]).packs().size();
        size_ += length;
        rows_[row_count_++] = {k, i, length};
        if (size_ >= filled || row_count_ == rows_.size()) sum();
    }

    /// Sums the rows that have been taken.
    void sum()
    {
        find_differences();
        const Differences<D>* packs = packs_.data();
        for (const Row& row : taken()) {
            PartSums<PackedSums<D>::count> parts{};
            for_each_part(
                row.length, [&](auto part, std::size_t)
                                __attribute__((always_inline)) { (packs++)->add_to(parts[part]); });
            PackedSums<D>::write(sums_[row.k], parts, model_.eos.rho0);
        }
        size_ = row_count_ = 0;
    }

private:
    static constexpr std::size_t filled = 40 * pack_lanes; // the batch stays within the nearest caches

    struct Row {
        std::size_t k = 0;
        int particle = 0;
        std::size_t length = 0;
    };

    std::span<const Row> taken() const { return std::span(rows_).first(row_count_); }

    void find_differences()
    {
        const auto state_of = [this](int j) { return records_.state(j); };
        const CubicSpline<D> kernel = model_.kernel;
        Differences<D>* pack = packs_.data();
        const int* others = others_.data();
        for (const Row& row : taken()) {
            const double* state = records_.state(row.particle);
            for (std::size_t n = 0; n < row.length; n += pack_lanes, others += pack_lanes)
                (pack++)->find(load_columns<8>(state_of, others), state, kernel);
        }
    }

    GradientField<D>& sums_;
    const PairRecords<D>& records_;
    const ReachedNeighbours& neighbours_;
    const FluidModel<D>& model_;
    std::vector<int> others_;
    std::vector<Differences<D>> packs_;
    std::array<Row, 32> rows_;
    std::size_t size_ = 0, row_count_ = 0;
};

template<int D, class Area> void finish(Particles<D>& particles, const GradientField<D>& sums, Area area)
{
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const auto i = static_cast<std::size_t>(particles.owned[k]);
        const GradientSums<D>& sum = sums[k];
        particles.renormaliser[i] = area.template renormaliser<D>(sum.moment);
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

} // namespace

template<int D>
void accumulate_fluid_gradients(GradientField<D>& sums, const PairRecords<D>& records,
                                const ReachedNeighbours& neighbours, const RowSet& rows, const FluidModel<D>& model)
{
    sums.resize(rows.all());
    GradientBatch<D> batch(sums, records, neighbours, model);
    rows.for_each([&](std::size_t k, int i) { batch.add(k, i); });
    batch.sum();
}

template<int D> void finish_gradients(Particles<D>& particles, const GradientField<D>& sums, const FluidModel<D>& model)
{
    std::visit([&](auto area) { finish(particles, sums, area); }, model.pair_area);
}

template void accumulate_fluid_gradients<2>(GradientField<2>&, const PairRecords<2>&, const ReachedNeighbours&,
                                            const RowSet&, const FluidModel<2>&);
template void accumulate_fluid_gradients<3>(GradientField<3>&, const PairRecords<3>&, const ReachedNeighbours&,
                                            const RowSet&, const FluidModel<3>&);
template void finish_gradients<2>(Particles<2>&, const GradientField<2>&, const FluidModel<2>&);
template void finish_gradients<3>(Particles<3>&, const GradientField<3>&, const FluidModel<3>&);

} // namespace sph

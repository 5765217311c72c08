// SPDX-License-Identifier: MIT
#include "sph_solver/operators/fluid_gradients.hpp"

#include <Eigen/LU>

namespace sph {
namespace {

/// The same sums as GradientSums, four neighbours side by side; the symmetric M as its upper triangle.
template<int D> struct PackedSums {
    std::array<Pack, D*(D + 1) / 2> moment{};
    std::array<Pack, D> ratio{};
    std::array<Pack, D * D> velocity{};

    /// Adds four neighbours, given as columns (x, v, q, w), to the sums of particle i.
    [[gnu::always_inline]] inline void add(const std::array<Pack, 8>& neighbour, const double* state,
                                           const CubicSpline<D>& kernel)
    {
        std::array<Pack, D> x, weighted;
        for (std::size_t a = 0; a < D; ++a) x[a] = neighbour[a] - state[a];
        const Pack r = square_root(dot(x, x) + 1e-300);
        const Pack weight = neighbour[2 * D + 1] * (kernel.slope(r) / r);
        for (std::size_t a = 0; a < D; ++a) weighted[a] = weight * x[a];

        const Pack ratio_jump = neighbour[2 * D] - state[2 * D];
        for (std::size_t a = 0, ab = 0; a < D; ++a) {
            for (std::size_t b = a; b < D; ++b, ++ab) moment[ab] = multiply_add(x[a], weighted[b], moment[ab]);
            ratio[a] = multiply_add(ratio_jump, weighted[a], ratio[a]);
            const Pack velocity_jump = neighbour[D + a] - state[D + a];
            for (std::size_t b = 0; b < D; ++b)
                velocity[a * D + b] = multiply_add(velocity_jump, weighted[b], velocity[a * D + b]);
        }
    }

    GradientSums<D> total(double rho0) const
    {
        GradientSums<D> sums;
        for (int a = 0, ab = 0; a < D; ++a) {
            const auto row = static_cast<std::size_t>(a);
            for (int b = a; b < D; ++b, ++ab) {
                sums.moment(a, b) = sum_lanes(moment[static_cast<std::size_t>(ab)]);
                sums.moment(b, a) = sums.moment(a, b);
            }
            sums.density[a] = rho0 * sum_lanes(ratio[row]);
            for (int b = 0; b < D; ++b)
                sums.velocity(a, b) = sum_lanes(velocity[row * D + static_cast<std::size_t>(b)]);
        }
        sums.fluid_divergence = sums.velocity.trace();
        return sums;
    }
};

} // namespace

template<int D>
void accumulate_fluid_gradients(GradientField<D>& sums, const PairRecords<D>& records, const NeighbourList& neighbours,
                                const std::vector<int>& owned, const FluidModel<D>& model)
{
    const auto state_of = [&](int j) { return records.state(j); };
    const CubicSpline<D> kernel = model.kernel;
    sums.resize(owned.size());
    for (std::size_t k = 0; k < owned.size(); ++k) {
        const double* state = records.state(owned[k]);
        PackedSums<D> packed;
        for_each_pack(neighbours.of(k), owned[k],
                      [&](const int* indices) { packed.add(load_columns<8>(state_of, indices), state, kernel); });
        sums[k] = packed.total(model.eos.rho0);
    }
}

template<int D> bool well_conditioned(const Mat<D>& moment)
{
    const Mat<D> shifted = moment - 0.2 * Mat<D>::Identity();
    bool positive = shifted(0, 0) > 0.0 && shifted.template topLeftCorner<2, 2>().determinant() > 0.0;
    if constexpr (D == 3) positive = positive && shifted.determinant() > 0.0;
    return positive;
}

template<int D> void finish_gradients(Particles<D>& particles, Rates<D>& rates, const GradientField<D>& sums)
{
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const auto i = static_cast<std::size_t>(particles.owned[k]);
        const GradientSums<D>& sum = sums[k];
        rates.volume[i] = particles.volume[i] * sum.divergence();
        particles.density_gradient[i] = sum.density;
        particles.velocity_gradient[i] = sum.velocity;
        if (well_conditioned<D>(sum.moment)) {
            const Mat<D> inverse = sum.moment.inverse();
            particles.density_gradient[i] = inverse * sum.density;
            particles.velocity_gradient[i] = sum.velocity * inverse;
        }
    }
}

template bool well_conditioned<2>(const Mat<2>&);
template bool well_conditioned<3>(const Mat<3>&);
template void accumulate_fluid_gradients<2>(GradientField<2>&, const PairRecords<2>&, const NeighbourList&,
                                            const std::vector<int>&, const FluidModel<2>&);
template void accumulate_fluid_gradients<3>(GradientField<3>&, const PairRecords<3>&, const NeighbourList&,
                                            const std::vector<int>&, const FluidModel<3>&);
template void finish_gradients<2>(Particles<2>&, Rates<2>&, const GradientField<2>&);
template void finish_gradients<3>(Particles<3>&, Rates<3>&, const GradientField<3>&);

} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/operators/shifting.hpp"

#include "sph_solver/numerics/eigenvalues.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

/// grad C_i, the first moment of the kernel's gradient [1/m].
template<int D>
Vec<D> concentration_gradient(const double* state, std::span<const int> row, const PairRecords<D>& records,
                              const CubicSpline<D>& kernel)
{
    PartSums<D> sum{};
    for_each_part(row.size(), [&](auto part, std::size_t n) {
        std::array<Pack, D> x;
        const auto other = load_columns<8>([&](int j) { return records.state(j); }, &row[n]);
        for (std::size_t a = 0; a < D; ++a) x[a] = other[a] - state[a];
        const Pack r = square_root(dot(x, x) + 1e-300);
        const Pack weight = other[2 * D + 1] * (kernel.slope(r) / r);
        for (std::size_t a = 0; a < D; ++a) sum[part][a] = multiply_add(weight, x[a], sum[part][a]);
    });
    const auto total = sum_lanes_of(sum);
    Vec<D> gradient;
    for (int a = 0; a < D; ++a) gradient[a] = total[static_cast<std::size_t>(a)];
    return gradient;
}

/// |D| = sqrt(2 D:D) [1/s].
template<int D> double strain_rate(const Mat<D>& velocity_gradient)
{
    const Mat<D> strain = 0.5 * (velocity_gradient + velocity_gradient.transpose());
    return std::sqrt(2.0) * strain.norm();
}

} // namespace

template<int D>
void find_shifts(Particles<D>& particles, const PairRecords<D>& records, const ReachedNeighbours& neighbours,
                 const GradientField<D>& sums, const Walls<D>& walls, const FluidModel<D>& model)
{
    constexpr double full_neighbourhood = 0.75, most = 0.2, fastest = 0.5;
    const double h = model.kernel.smoothing_length();
    const auto* motion = std::get_if<ShiftedMotion>(&model.face_motion);
    if (!motion) return;
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const auto i = static_cast<std::size_t>(particles.owned[k]);
        particles.shift[i].setZero();
        if (!eigenvalues_exceed<D>(sums[k].moment, full_neighbourhood)) continue;
        const ReachedRow row = neighbours.row(k, particles.owned[k]);
        Vec<D> uneven =
            h * concentration_gradient<D>(records.state(particles.owned[k]), row.packs(), records, model.kernel);
        if (uneven.norm() > most) uneven *= most / uneven.norm();
        const double speed =
            std::min(motion->beta * h * strain_rate<D>(particles.velocity_gradient[i]), fastest * model.eos.c0);
        particles.shift[i] = -speed * uneven;
    }
    for (const WallContact& contact : walls.contacts().contacts)
        particles.shift[static_cast<std::size_t>(contact.particle)].setZero();
}

template void find_shifts<2>(Particles<2>&, const PairRecords<2>&, const ReachedNeighbours&, const GradientField<2>&,
                             const Walls<2>&, const FluidModel<2>&);
template void find_shifts<3>(Particles<3>&, const PairRecords<3>&, const ReachedNeighbours&, const GradientField<3>&,
                             const Walls<3>&, const FluidModel<3>&);

} // namespace sph

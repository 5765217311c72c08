// SPDX-License-Identifier: MIT
#include "sph_solver/operators/wall_gradients.hpp"

#include "sph_solver/operators/image_packs.hpp"

namespace sph {
namespace {

/// The sums of a group of images, lane by lane: M and G[v] row by row, then G[q].
template<int D> struct ImageSums {
    static constexpr std::size_t velocity = D * D, ratio = 2 * D * D, count = ratio + D;

    /// \param weight share of the volume times |W'|/r; x from the particle to the images; jumps likewise
    [[gnu::always_inline]] static inline void add(std::array<Pack, count>& sums, const PackVector<D>& x,
                                                  const PackVector<D>& velocity_jump, Pack ratio_jump, Pack weight)
    {
        for (std::size_t b = 0; b < D; ++b) {
            const Pack weighted = weight * x[b];
            sums[ratio + b] = multiply_add(ratio_jump, weighted, sums[ratio + b]);
            for (std::size_t a = 0; a < D; ++a) {
                const std::size_t ab = a * D + b;
                sums[ab] = multiply_add(x[a], weighted, sums[ab]);
                sums[velocity + ab] = multiply_add(velocity_jump[a], weighted, sums[velocity + ab]);
            }
        }
    }

    static void add_to(GradientSums<D>& result, const PartSums<count>& parts, double rho0)
    {
        const auto total = sum_lanes_of(parts);
        for (std::size_t b = 0; b < D; ++b) {
            const int column = static_cast<int>(b);
            result.density[column] += rho0 * total[ratio + b];
            for (std::size_t a = 0; a < D; ++a) {
                result.moment(static_cast<int>(a), column) += total[a * D + b];
                result.velocity(static_cast<int>(a), column) += total[velocity + a * D + b];
            }
        }
    }
};

} // namespace

template<int D>
void accumulate_wall_gradients(GradientField<D>& sums, const WallImages<D>& images, const Walls<D>& walls,
                               const PairRecords<D>& records, const FluidModel<D>& model)
{
    const auto& [contacts, planes, footprints] = walls.contacts();
    const auto state_of = [&](int j) { return records.state(j); };
    for (const ImageGroup& group : images.groups()) {
        const WallContact& contact = contacts[group.contact];
        const double* state_i = records.state(contact.particle);
        const MirrorPath<D> path(group, planes, walls.settings(), model.eos.c0, false);
        PartSums<ImageSums<D>::count> parts{};
        for_each_part(group.end - group.begin, [&](auto part, std::size_t n) {
            const std::size_t at = group.begin + n;
            const auto source = load_columns<8>(state_of, images.sources() + at);
            const ImagePack<D> image = path.values(source, group.own_first && n == 0);
            PackVector<D> x, jump;
            for (std::size_t a = 0; a < D; ++a) {
                x[a] = image.x[a] - state_i[a];
                jump[a] = image.velocity[a] - state_i[D + a];
            }
            const Pack r = square_root(dot(x, x) + 1e-300);
            const Pack weight = load_pack(images.weights(group, at)) * source[2 * D + 1] * (model.kernel.slope(r) / r);
            ImageSums<D>::add(parts[part], x, jump, image.ratio - state_i[2 * D], weight);
        });
        ImageSums<D>::add_to(sums[contact.row], parts, model.eos.rho0);
    }
}

template void accumulate_wall_gradients<2>(GradientField<2>&, const WallImages<2>&, const Walls<2>&,
                                           const PairRecords<2>&, const FluidModel<2>&);
template void accumulate_wall_gradients<3>(GradientField<3>&, const WallImages<3>&, const Walls<3>&,
                                           const PairRecords<3>&, const FluidModel<3>&);

} // namespace sph

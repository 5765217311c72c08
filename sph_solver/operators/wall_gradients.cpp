// SPDX-License-Identifier: MIT
#include "sph_solver/operators/wall_gradients.hpp"

#include "sph_solver/operators/image_packs.hpp"

namespace sph {
namespace {

/// The sums of a group of images, lane by lane.
template<int D> struct ImageSums {
    std::array<Pack, D * D> moment{}, velocity{};
    std::array<Pack, D> ratio{};

    /// \param weight share of the volume times |W'|/r; x from the particle to the images; jumps likewise
    [[gnu::always_inline]] inline void add(const PackVector<D>& x, const PackVector<D>& velocity_jump, Pack ratio_jump,
                                           Pack weight)
    {
        for (std::size_t b = 0; b < D; ++b) {
            const Pack weighted = weight * x[b];
            ratio[b] = multiply_add(ratio_jump, weighted, ratio[b]);
            for (std::size_t a = 0; a < D; ++a) {
                moment[a * D + b] = multiply_add(x[a], weighted, moment[a * D + b]);
                velocity[a * D + b] = multiply_add(velocity_jump[a], weighted, velocity[a * D + b]);
            }
        }
    }

    void add_to(GradientSums<D>& sums, double rho0) const
    {
        for (int b = 0; b < D; ++b) {
            sums.density[b] += rho0 * sum_lanes(ratio[static_cast<std::size_t>(b)]);
            for (int a = 0; a < D; ++a) {
                sums.moment(a, b) += sum_lanes(moment[static_cast<std::size_t>(a * D + b)]);
                sums.velocity(a, b) += sum_lanes(velocity[static_cast<std::size_t>(a * D + b)]);
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
        ImageSums<D> group_sums;
        for (std::size_t n = group.begin; n < group.end; n += pack_size) {
            const auto source = load_columns<8>(state_of, images.sources() + n);
            const ImagePack<D> image = path.values(source, group.own_first && n == group.begin);
            PackVector<D> x, jump;
            for (std::size_t a = 0; a < D; ++a) {
                x[a] = image.x[a] - state_i[a];
                jump[a] = image.velocity[a] - state_i[D + a];
            }
            const Pack r = square_root(dot(x, x) + 1e-300);
            const Pack weight = load_pack(images.weights() + n) * source[2 * D + 1] * (model.kernel.slope(r) / r);
            group_sums.add(x, jump, image.ratio - state_i[2 * D], weight);
        }
        group_sums.add_to(sums[contact.row], model.eos.rho0);
    }
}

template void accumulate_wall_gradients<2>(GradientField<2>&, const WallImages<2>&, const Walls<2>&,
                                           const PairRecords<2>&, const FluidModel<2>&);
template void accumulate_wall_gradients<3>(GradientField<3>&, const WallImages<3>&, const Walls<3>&,
                                           const PairRecords<3>&, const FluidModel<3>&);

} // namespace sph

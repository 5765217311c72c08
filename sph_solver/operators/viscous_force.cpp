// SPDX-License-Identifier: MIT
#include "sph_solver/operators/viscous_force.hpp"

#include "sph_solver/operators/image_packs.hpp"
#include "sph_solver/operators/share_out.hpp"

namespace sph {
namespace {

/// Adds w_j (|W'|/r) (v_j - v_i) of a pack of neighbours.
template<int D>
[[gnu::always_inline]] inline void add_pull(PackVector<D>& sum, const PackVector<D>& x,
                                            const PackVector<D>& velocity_jump, Pack volume,
                                            const CubicSpline<D>& kernel)
{
    const Pack r = square_root(dot(x, x) + 1e-300);
    const Pack pull = volume * (kernel.slope(r) / r);
    for (std::size_t a = 0; a < D; ++a) sum[a] = multiply_add(pull, velocity_jump[a], sum[a]);
}

template<int D> Vec<D> total(const PartSums<D>& parts, double factor)
{
    const auto sum = sum_lanes_of(parts);
    Vec<D> result;
    for (int a = 0; a < D; ++a) result[a] = factor * sum[static_cast<std::size_t>(a)];
    return result;
}

} // namespace

template<int D>
void ViscousForce<D>::add(Rates<D>& rates, std::vector<Vec<D>>& sums, const PairRecords<D>& records,
                          const ReachedNeighbours& neighbours, const RowSet& rows) const
{
    rows.for_each([&](std::size_t k, int i) {
        const double* state = records.state(i);
        const auto row = neighbours.row(k, i).packs();
        PartSums<D> sum{};
        for_each_part(row.size(), [&](auto part, std::size_t n) {
            PackVector<D> x, jump;
            const auto other = load_columns<8>([&](int j) { return records.state(j); }, &row[n]);
            for (std::size_t a = 0; a < D; ++a) {
                x[a] = other[a] - state[a];
                jump[a] = other[D + a] - state[D + a];
            }
            add_pull<D>(sum[part], x, jump, other[2 * D + 1], model_.kernel);
        });
        const Vec<D> force = total<D>(sum, factor_ * PairRecords<D>::volume(state));
        sums[k] += force;
        rates.momentum[static_cast<std::size_t>(i)] += force;
    });
}

template<int D>
void ViscousForce<D>::add_at_walls(WallForces<D>& forces, const WallImages<D>& images, const Walls<D>& walls,
                                   const PairRecords<D>& records) const
{
    const auto& [contacts, planes, footprints] = walls.contacts();
    for (const ImageGroup& group : images.groups()) {
        const double* state = records.state(contacts[group.contact].particle);
        const MirrorPath<D> path(group, planes, walls.settings(), model_.eos.c0, false);
        PartSums<D> sum{};
        for_each_part(group.end - group.begin, [&](auto part, std::size_t n) {
            PackVector<D> x, jump;
            const std::size_t at = group.begin + n;
            const auto source = load_columns<8>([&](int j) { return records.state(j); }, images.sources() + at);
            const ImagePack<D> image = path.values(source, group.own_first && n == 0);
            for (std::size_t a = 0; a < D; ++a) {
                x[a] = image.x[a] - state[a];
                jump[a] = image.velocity[a] - state[D + a];
            }
            add_pull<D>(sum[part], x, jump, load_pack(images.weights(group, at)) * source[2 * D + 1], model_.kernel);
        });
        const Vec<D> force = total<D>(sum, factor_ * PairRecords<D>::volume(state));
        forces.on_particle[group.contact] += force;
        share_out<D>(-force, group, planes, forces.on_wall);
    }
}

template class ViscousForce<2>;
template class ViscousForce<3>;

} // namespace sph

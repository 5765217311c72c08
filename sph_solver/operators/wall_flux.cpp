// SPDX-License-Identifier: MIT
#include "sph_solver/operators/wall_flux.hpp"

#include "sph_solver/numerics/muscl.hpp"
#include "sph_solver/operators/image_packs.hpp"
#include "sph_solver/operators/share_out.hpp"

namespace sph {
namespace {

/// The faces towards a group's images, several packs after one another in each of three short loops (as in
/// operators/fluid_flux.cpp).
template<int D> class ImageFaces {
public:
    ImageFaces(const WallImages<D>& images, const PairRecords<D>& records, const FluidModel<D>& model)
        : images_(images), records_(records), model_(model)
    {}

    /// What crosses the faces of a group.
    struct Sums {
        Vec<D> force;    ///< sum of S p_e n, of particle i on its walls
        double dilation; ///< sum of S n.(v' - v_i)/2
    };

    template<class AnyLimiter> Sums sum(const ImageGroup& group, int i, const MirrorPath<D>& path, AnyLimiter limiter)
    {
        PartSums<D + 1> parts{};
        pushed_ = path.pushed();
        for (std::size_t part = 0; part < pack_parts; ++part) {
            for (std::size_t begin = group.begin; begin < group.end; begin += batch * row_unit) {
                const std::size_t count = std::min(batch, (group.end - begin) / row_unit);
                for (std::size_t n = 0; n < count; ++n) {
                    const std::size_t at = begin + n * row_unit + part * pack_lanes;
                    reconstruct(n, at, i, path, group, limiter);
                }
                std::visit([&](auto riemann) { solve_riemann_problems(riemann, count); }, model_.riemann);
                add(parts[part], count);
            }
        }
        const auto sum = sum_lanes_of(parts);
        Sums total{Vec<D>::Zero(), sum[D]};
        for (int a = 0; a < D; ++a) total.force[a] = sum[static_cast<std::size_t>(a)];
        return total;
    }

private:
    static constexpr std::size_t batch = 8; // packs

    void add(std::array<Pack, D + 1>& sum, std::size_t count) const
    {
        for (std::size_t n = 0; n < count; ++n) {
            const Pack pressure = area_[n] * model_.eos.pressure_at_ratio(stars_[n]);
            for (std::size_t a = 0; a < D; ++a) sum[a] = multiply_add(pressure, x_[n][a], sum[a]);
            sum[D] = multiply_add(area_[n], opening_[n], sum[D]);
        }
    }

    template<class AnyRiemann> void solve_riemann_problems(AnyRiemann riemann, std::size_t count)
    {
        for (std::size_t n = 0; n < count; ++n) stars_[n] = riemann(faces_[n]).q;
    }

    template<class AnyLimiter>
    [[gnu::always_inline]] inline void reconstruct(std::size_t n, std::size_t at, int i, const MirrorPath<D>& path,
                                                   const ImageGroup& group, AnyLimiter limiter)
    {
        const double* state_i = records_.state(i);
        const double* slope_i = records_.slope(i);
        const int* sources = images_.sources() + at;
        const auto source = load_columns<8>([this](int j) { return records_.state(j); }, sources);
        const auto slope =
            load_columns<PairRecords<D>::slope_size>([this](int j) { return records_.slope(j); }, sources);
        const ImagePack<D> image = path.values(source, group.own_first && at == group.begin);
        PairView<D, Pack> pair{};
        RatioView<Pack> q{everywhere(state_i[2 * D]), image.ratio, Pack{}, Pack{}};
        for (std::size_t a = 0; a < D; ++a) {
            pair.x[a] = image.x[a] - state_i[a];
            pair.velocity_jump[a] = image.velocity[a] - state_i[D + a];
        }
        for (std::size_t a = 0; a < D; ++a) {
            q.slope_i = multiply_add(everywhere(slope_i[a]), pair.x[a], q.slope_i);
            for (std::size_t b = 0; b < D; ++b)
                pair.velocity_slope_i[a] =
                    multiply_add(everywhere(slope_i[D + a * D + b]), pair.x[b], pair.velocity_slope_i[a]);
        }
        path.predict(q.slope_j, pair.velocity_slope_j, slope, image, pair.x);
        const Pack r = square_root(dot(pair.x, pair.x) + 1e-300);
        pair.inverse_distance = 1.0 / r;
        area_[n] = load_pack(images_.weights(group, at)) * source[2 * D + 1] * pair.inverse_distance *
                   ((2.0 * state_i[2 * D + 1]) * model_.kernel.slope(r));
        faces_[n] = reconstruct_face(pair, q, 1.0 / model_.eos.c0, limiter);
        x_[n] = pair.x;
        opening_[n] = 0.5 * dot(pair.velocity_jump, pair.x);
        for (std::size_t a = 0; a < D; ++a) opening_[n] -= (0.5 * pushed_[a]) * pair.x[a];
    }

    const WallImages<D>& images_;
    const PairRecords<D>& records_;
    const FluidModel<D> model_;
    std::array<double, D> pushed_{};
    std::array<FaceStates<Pack>, batch> faces_;
    std::array<PackVector<D>, batch> x_;
    std::array<Pack, batch> area_, opening_, stars_; ///< 2 w_i w' |W'|/r [m^(D-2)]; (v' - v_i)/2 . x; q*
};

template<int D, class AnyLimiter>
void sum_forces(WallForces<D>& forces, const WallImages<D>& images, const Walls<D>& walls,
                const PairRecords<D>& records, const FluidModel<D>& model, AnyLimiter limiter)
{
    const auto& [contacts, planes, footprints] = walls.contacts();
    ImageFaces<D> faces(images, records, model);
    for (const ImageGroup& group : images.groups()) {
        const MirrorPath<D> path(group, planes, walls.settings(), model.eos.c0, true);
        const auto sum = faces.sum(group, contacts[group.contact].particle, path, limiter);
        forces.on_particle[group.contact] -= sum.force;
        forces.dilation[group.contact] += sum.dilation;
        share_out(sum.force, group, planes, forces.on_wall);
    }
}

} // namespace

template<int D>
void find_wall_forces(WallForces<D>& forces, const WallImages<D>& images, const Walls<D>& walls,
                      const PairRecords<D>& records, const FluidModel<D>& model)
{
    forces.on_particle.assign(walls.contacts().contacts.size(), Vec<D>::Zero());
    forces.dilation.assign(walls.contacts().contacts.size(), 0.0);
    forces.on_wall.assign(walls.contacts().planes.size(), Vec<D>::Zero());
    std::visit([&](auto limiter) { sum_forces(forces, images, walls, records, model, limiter); }, model.limiter);
}

template<int D> void add_wall_forces(Rates<D>& rates, const WallForces<D>& forces, const Walls<D>& walls)
{
    const auto& contacts = walls.contacts().contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const auto i = static_cast<std::size_t>(contacts[c].particle);
        rates.momentum[i] += forces.on_particle[c];
        rates.volume[i] += forces.dilation[c];
    }
}

template<int D>
void add_wall_power(WallPower& power, double weight, const WallForces<D>& forces, const Walls<D>& walls,
                    const Particles<D>& particles)
{
    const auto& planes = walls.contacts().planes;
    for (std::size_t c = 0; c < walls.contacts().contacts.size(); ++c) {
        const WallContact& contact = walls.contacts().contacts[c];
        const auto i = static_cast<std::size_t>(contact.particle);
        double work = 0;
        for (auto p = static_cast<std::size_t>(contact.plane_begin); p < static_cast<std::size_t>(contact.plane_end);
             ++p) {
            const double part = -forces.on_wall[p].dot(planes[p].velocity);
            const bool wet = walls.facets().is_wet(planes[p].facet);
            (wet ? power.by_interface : power.by_walls).add(weight * part);
            auto& force = wet ? power.force_of_interface : power.force_of_walls;
            for (int a = 0; a < D; ++a) force[static_cast<std::size_t>(a)].add(-weight * forces.on_wall[p][a]);
            work += part;
        }
        const double gain =
            particles.velocity[i].dot(forces.on_particle[c]) - particles.pressure[i] * forces.dilation[c];
        power.dissipation.add(weight * (work - gain));
    }
}

template void find_wall_forces<2>(WallForces<2>&, const WallImages<2>&, const Walls<2>&, const PairRecords<2>&,
                                  const FluidModel<2>&);
template void find_wall_forces<3>(WallForces<3>&, const WallImages<3>&, const Walls<3>&, const PairRecords<3>&,
                                  const FluidModel<3>&);
template void add_wall_forces<2>(Rates<2>&, const WallForces<2>&, const Walls<2>&);
template void add_wall_forces<3>(Rates<3>&, const WallForces<3>&, const Walls<3>&);
template void add_wall_power<2>(WallPower&, double, const WallForces<2>&, const Walls<2>&, const Particles<2>&);
template void add_wall_power<3>(WallPower&, double, const WallForces<3>&, const Walls<3>&, const Particles<3>&);

} // namespace sph

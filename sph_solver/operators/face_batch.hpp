// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/numerics/muscl.hpp"
#include "sph_solver/operators/flux_sums.hpp"
#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "sph_solver/operators/pair_records.hpp"

namespace sph {

/// Sum of a[k] x[k]: a gradient's prediction along the pairs. `Row` is a row of numbers or of packs.
template<std::size_t D, class Row>
[[gnu::always_inline]] inline Pack along(const Row* gradient, const std::array<Pack, D>& x)
{
    Pack sum = gradient[0] * x[0];
    for (std::size_t b = 1; b < D; ++b) sum = multiply_add(everywhere(gradient[b]), x[b], sum);
    return sum;
}

/// The same sums as FluxSums, neighbours side by side.
template<int D> struct FluxPacks {
    static constexpr std::size_t mass = 0, by_mass = 1, by_pressure = 1 + D, dilation = 1 + 2 * D, swept = 2 + 2 * D;
    static constexpr std::size_t count = 3 + 2 * D;

    static void write(FluxSums<D>& result, const PartSums<count>& parts)
    {
        const auto total = sum_lanes_of(parts);
        result.mass = total[mass];
        for (std::size_t a = 0; a < D; ++a) {
            result.by_mass[static_cast<int>(a)] = total[by_mass + a];
            result.by_pressure[static_cast<int>(a)] = total[by_pressure + a];
        }
        result.dilation = total[dilation];
        result.swept = total[swept];
    }
};

/// The faces of a batch of particles towards their neighbours, in packs. The work is split in three loops over
/// the packs: each pack is a long chain of dependent operations, and a processor overlaps the chains of several packs
/// where the loops are short in code and long in turns.
template<int D, class AnyLimiter, class Motion, class Area> class FaceBatch {
public:
    FaceBatch(const PairRecords<D>& records, std::size_t longest_row, const FluidModel<D>& model, AnyLimiter limiter,
              Motion motion)
        : records_(records),
          model_(model),
          limiter_(limiter),
          motion_(motion),
          faces_(filled + longest_row / pack_lanes)
    {}

    /// 1. Reconstructs the faces of particle i, whose sums go to `sums` when the batch is solved.
    void reconstruct(int i, std::span<const int> neighbours, FluxSums<D>& sums)
    {
        for (std::size_t n = 0; n < neighbours.size(); n += pack_lanes)
            reconstruct_pack(faces_[size_++], records_.state(i), records_.slope(i), i, &neighbours[n]);
        rows_[row_count_++] = {&sums, neighbours.size()};
    }

    bool full() const { return size_ >= filled || row_count_ == rows_.size(); }

    /// 2. Solves the Riemann problems. 3. Sums what crosses the faces of each particle. The batch is empty then.
    void solve()
    {
        std::visit([this](auto riemann) { solve_riemann_problems(riemann); }, model_.riemann);
        std::size_t n = 0;
        for (std::size_t row = 0; row < row_count_; ++row) {
            PartSums<FluxPacks<D>::count> parts{};
            for_each_part(
                rows_[row].length, [&](auto part, std::size_t)
                                       __attribute__((always_inline)) { add(parts[part], faces_[n++]); });
            FluxPacks<D>::write(*rows_[row].sums, parts);
        }
        size_ = 0;
        row_count_ = 0;
    }

private:
    static constexpr std::size_t filled = 40; // packs: the batch stays within the nearest caches

    struct Row {
        FluxSums<D>* sums = nullptr;
        std::size_t length = 0; // entries, whole packs
    };

    /// Faces of one particle, a pack of them, as each loop leaves them to the next.
    struct Faces {
        FaceFrame<D, Pack> frame;
        FaceStates<Pack> sides;
        StarState<Pack> star;
        Pack strength;                 ///< S = 2 w_i w_j |W'| [m^(D-1)]
        FaceShift<Pack> shift;         ///< where particles are shifted
        std::array<Pack, D> direction; ///< where areas are renormalised: (K_i + K_j)/2 x_ij [m]
        Pack opening;                  ///< there: (v_j - v_i)/2 . (direction - x_ij) [m^2/s]
    };

    [[gnu::always_inline]] inline void reconstruct_pack(Faces& faces, const double* state_i, const double* slope_i,
                                                        int i, const int* indices)
    {
        const auto state = load_columns<8>([this](int j) { return records_.state(j); }, indices);
        const auto slope =
            load_columns<PairRecords<D>::slope_size>([this](int j) { return records_.slope(j); }, indices);
        PairView<D, Pack> pair;
        std::array<Pack, D> mean_velocity;
        for (std::size_t a = 0; a < D; ++a) {
            pair.x[a] = state[a] - state_i[a];
            pair.velocity_jump[a] = state[D + a] - state_i[D + a];
            mean_velocity[a] = 0.5 * (state[D + a] + state_i[D + a]);
        }
        for (std::size_t a = 0; a < D; ++a) {
            pair.velocity_slope_i[a] = along(slope_i + D + a * D, pair.x);
            pair.velocity_slope_j[a] = along(slope.data() + D + a * D, pair.x);
        }
        const Pack r = square_root(dot(pair.x, pair.x) + 1e-300);
        pair.inverse_distance = 1.0 / r;
        faces.strength = (state_i[2 * D + 1] * state[2 * D + 1]) * (2.0 * model_.kernel.slope(r));
        const RatioView<Pack> q{everywhere(state_i[2 * D]), state[2 * D], along(slope_i, pair.x),
                                along(slope.data(), pair.x)};
        faces.sides = reconstruct_face(pair, q, 1.0 / model_.eos.c0, limiter_);
        if constexpr (Motion::shifts) faces.shift = face_shift(slope_i, slope, pair);
        if constexpr (Area::renormalises) renormalise(faces, pair, i, indices);
        faces.frame = face_frame<D>(pair, mean_velocity);
    }

    [[gnu::always_inline]] inline void renormalise(Faces& faces, const PairView<D, Pack>& pair, int i,
                                                   const int* indices)
    {
        const double* area_i = records_.area(i);
        const auto area = load_columns<PairRecords<D>::area_size>([this](int j) { return records_.area(j); }, indices);
        Pack opening{};
        for (std::size_t a = 0; a < D; ++a) {
            Pack direction{};
            for (std::size_t b = 0; b < D; ++b) direction += (area[a * D + b] + area_i[a * D + b]) * (0.5 * pair.x[b]);
            opening += pair.velocity_jump[a] * (direction - pair.x[a]);
            faces.direction[a] = direction;
        }
        faces.opening = 0.5 * opening;
    }

    static FaceShift<Pack> face_shift(const double* slope_i, const std::array<Pack, PairRecords<D>::slope_size>& slope,
                                      const PairView<D, Pack>& pair)
    {
        constexpr std::size_t shift = PairRecords<D>::shift;
        Pack sum{}, jump{};
        for (std::size_t a = 0; a < D; ++a) {
            sum += (slope[shift + a] + slope_i[shift + a]) * pair.x[a];
            jump += (slope[shift + a] - slope_i[shift + a]) * pair.x[a];
        }
        const Pack half = 0.5 * pair.inverse_distance;
        return {half * sum, half * jump};
    }

    template<class AnyRiemann> void solve_riemann_problems(AnyRiemann riemann)
    {
        for (std::size_t n = 0; n < size_; ++n) faces_[n].star = riemann(faces_[n].sides);
    }

    [[gnu::always_inline]] inline void add(std::array<Pack, FluxPacks<D>::count>& sums, const Faces& faces) const
    {
        using At = FluxPacks<D>;
        const Tait& eos = model_.eos;
        const auto transport = motion_(eos.c0 * faces.star.u, faces.shift);
        const Pack per_length = faces.strength * faces.frame.inverse_distance;
        const Pack pressure = eos.pressure_at_ratio(faces.star.q) * per_length;
        const auto& direction = Area::renormalises ? faces.direction : faces.frame.x;
        for (std::size_t a = 0; a < D; ++a)
            sums[At::by_pressure + a] = multiply_add(-pressure, direction[a], sums[At::by_pressure + a]);
        if constexpr (Area::renormalises)
            sums[At::dilation] = multiply_add(per_length, faces.opening, sums[At::dilation]);
        if constexpr (Motion::dilates)
            sums[At::dilation] = multiply_add(faces.strength, transport.dilation, sums[At::dilation]);
        if constexpr (Motion::shifts) sums[At::swept] = multiply_add(faces.strength, transport.swept, sums[At::swept]);
        if constexpr (Motion::exchanges_mass) {
            const auto velocity = face_velocity(faces.frame, transport.relative, limiter_);
            const Pack mass_flux = faces.strength * (eos.rho0 * faces.star.q * transport.relative);
            sums[At::mass] -= mass_flux;
            for (std::size_t a = 0; a < D; ++a)
                sums[At::by_mass + a] = multiply_add(-mass_flux, velocity[a], sums[At::by_mass + a]);
        }
    }

    const PairRecords<D>& records_;
    const FluidModel<D> model_;
    const AnyLimiter limiter_;
    const Motion motion_;
    std::size_t size_ = 0, row_count_ = 0;
    std::array<Row, 32> rows_;
    std::vector<Faces> faces_;
};

} // namespace sph

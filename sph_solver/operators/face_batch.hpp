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

/// The numbers of FluxSums in a row, whole cache lines; what one of them says of i, its opposite says of j, but for
/// those that both sides of a face get alike.
template<int D, bool shifts> struct FluxRow {
    static constexpr std::size_t mass = 0, by_mass = 1, by_pressure = 1 + D, dilation = 1 + 2 * D, swept = 2 + 2 * D;
    static constexpr std::size_t count = shifts ? 3 + 2 * D : 2 + 2 * D;
    static constexpr std::size_t size = count <= 8 ? 8 : 16;

    alignas(64) std::array<double, size> data{};

    /// The sums of this row and of what the lanes hold.
    [[nodiscard]] FluxSums<D> plus(const PartSums<count>& parts) const
    {
        const auto right = sum_lanes_of(parts);
        const auto at = [&](std::size_t n) { return data[n] + right[n]; };
        FluxSums<D> total;
        total.mass = at(mass);
        for (std::size_t a = 0; a < D; ++a) {
            total.by_mass[static_cast<int>(a)] = at(by_mass + a);
            total.by_pressure[static_cast<int>(a)] = at(by_pressure + a);
        }
        total.dilation = at(dilation);
        if constexpr (shifts) total.swept = at(swept);
        return total;
    }
};

/// The faces of a batch of particles towards their neighbours, in packs. The work is split in three loops over
/// the packs: each pack is a long chain of dependent operations, and a processor overlaps the chains of several packs
/// where the loops are short in code and long in turns.
///
/// A face is solved once, by the row of its first particle, which gives the other its opposite. The sums of a particle
/// are those of the faces before it, one after the other, and then the tree over those behind: so they keep their
/// bits where a face before it must be solved by the row itself, because the other particle has no row here.
template<int D, class AnyLimiter, class Motion, class Area> class FaceBatch {
public:
    FaceBatch(const PairRecords<D>& records, std::size_t longest_row, const FluidModel<D>& model, AnyLimiter limiter,
              Motion motion)
        : records_(records),
          model_(model),
          limiter_(limiter),
          motion_(motion),
          faces_(filled + longest_row / pack_lanes + 2),
          received_(records.size())
    {}

    /// 1. Reconstructs the faces of particle i, whose sums go to `sums` when the batch is solved. Rows come in
    /// ascending order.
    /// \param before neighbours j < i, if i has to solve these faces itself; then all of them
    /// \param after neighbours j > i, whole packs
    void reconstruct(int i, std::span<const int> before, std::span<const int> after, FluxSums<D>& sums)
    {
        for (const auto side : {before, after})
            for (std::size_t n = 0; n < side.size(); n += pack_lanes)
                reconstruct_pack(faces_[size_++], records_.state(i), records_.slope(i), i, &side[n]);
        rows_[row_count_++] = {i, before.size(), after, &sums};
    }

    bool full() const { return size_ >= filled || row_count_ == rows_.size(); }

    /// 2. Solves the Riemann problems. 3. Sums what crosses the faces of each particle. The batch is empty then.
    void solve()
    {
        std::visit([this](auto riemann) { solve_riemann_problems(riemann); }, model_.riemann);
        const Faces* faces = faces_.data();
        for (const Row& row : std::span(rows_).first(row_count_)) {
            faces = sum_before(faces, row);
            faces = sum_after(faces, row);
        }
        size_ = 0;
        row_count_ = 0;
    }

private:
    static constexpr std::size_t filled = 40; // packs: the batch stays within the nearest caches

    using Received = FluxRow<D, Motion::shifts>;
    using Columns = std::array<Pack, Received::size>;

    struct Row {
        int particle = 0;
        std::size_t before = 0;     // faces solved here
        std::span<const int> after; // whole packs
        FluxSums<D>* sums = nullptr;
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

    /// What i gets through a pack of faces, and what the others get.
    [[gnu::always_inline]] inline void cross(const Faces& faces, Columns& here, Columns& there) const
    {
        using At = Received;
        const Tait& eos = model_.eos;
        const auto transport = motion_(eos.c0 * faces.star.u, faces.shift);
        const Pack per_length = faces.strength * faces.frame.inverse_distance;
        const Pack pressure = eos.pressure_at_ratio(faces.star.q) * per_length;
        const auto& direction = Area::renormalises ? faces.direction : faces.frame.x;
        for (std::size_t a = 0; a < D; ++a) there[At::by_pressure + a] = pressure * direction[a];
        if constexpr (Motion::exchanges_mass) {
            const auto velocity = face_velocity(faces.frame, transport.relative, limiter_);
            there[At::mass] = faces.strength * (eos.rho0 * faces.star.q * transport.relative);
            for (std::size_t a = 0; a < D; ++a) there[At::by_mass + a] = there[At::mass] * velocity[a];
        }
        if constexpr (Motion::dilates) there[At::dilation] = -(faces.strength * transport.dilation);
        for (std::size_t n = 0; n < At::count; ++n) here[n] = -there[n];
        if constexpr (Area::renormalises) { // both sides alike
            const Pack opened = per_length * faces.opening;
            here[At::dilation] += opened;
            there[At::dilation] += opened;
        }
        if constexpr (Motion::shifts) here[At::swept] = there[At::swept] = faces.strength * transport.swept;
    }

    /// Adds what each lane of a pack gives to the row at place(lane).
    template<class Place> [[gnu::always_inline]] static inline void add_lanes(const Columns& columns, Place place)
    {
        for (std::size_t begin = 0; begin < Received::size; begin += 8) {
            std::array<Pack, 8> part;
            for (std::size_t n = 0; n < 8; ++n) part[n] = columns[begin + n];
            add_rows(part, [&](std::size_t lane) { return place(lane).data.data() + begin; });
        }
    }

    /// Where a row solves the faces before it, what it has received counts for nothing.
    const Faces* sum_before(const Faces* faces, const Row& row)
    {
        if (row.before == 0) return faces;
        Received sum, beyond;
        for (std::size_t n = 0; n < row.before; n += pack_lanes) {
            Columns here{}, there{};
            cross(*faces++, here, there);
            add_lanes(here, [&](std::size_t lane) -> Received& { return n + lane < row.before ? sum : beyond; });
        }
        received_[static_cast<std::size_t>(row.particle)] = sum;
        return faces;
    }

    const Faces* sum_after(const Faces* faces, const Row& row)
    {
        PartSums<Received::count> parts{};
        for_each_part(
            row.after.size(), [&](auto part, std::size_t n) __attribute__((always_inline)) {
                Columns here{}, there{};
                cross(*faces++, here, there);
                unrolled<Received::count>([&](auto k) __attribute__((always_inline)) { parts[part][k] += here[k]; });
                add_lanes(there, [&](std::size_t lane) -> Received& {
                    return received_[static_cast<std::size_t>(row.after[n + lane])];
                });
            });
        *row.sums = received_[static_cast<std::size_t>(row.particle)].plus(parts);
        return faces;
    }

    const PairRecords<D>& records_;
    const FluidModel<D> model_;
    const AnyLimiter limiter_;
    const Motion motion_;
    std::size_t size_ = 0, row_count_ = 0;
    std::array<Row, 32> rows_;
    std::vector<Faces> faces_;
    std::vector<Received> received_; ///< by each local particle from the faces before it
};

} // namespace sph

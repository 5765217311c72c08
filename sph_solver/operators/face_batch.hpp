// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/numerics/muscl.hpp"
#include "sph_solver/operators/flux_sums.hpp"
#include "sph_solver/operators/pair_batch.hpp"
#include "sph_solver/operators/pair_records.hpp"

namespace sph {

/// Sum of a[k] x[k]: a gradient's prediction along the pairs. \param gradient first of D packs
template<std::size_t D> [[gnu::always_inline]] inline Pack along(const Pack* gradient, const std::array<Pack, D>& x)
{
    Pack sum = gradient[0] * x[0];
    for (std::size_t b = 1; b < D; ++b) sum = multiply_add(gradient[b], x[b], sum);
    return sum;
}

/// Places of the numbers of FluxSums, as they cross a face. What one of them says of i, its opposite says of j, up to
/// `alike`, where those begin that both sides of a face get alike.
template<int D, class Motion, class Area> struct FluxPlaces {
    static constexpr std::size_t mass = 0, by_mass = 1, by_pressure = 1 + D, dilation = 1 + 2 * D;
    static constexpr std::size_t alike = dilation + (Motion::dilates ? 1 : 0);
    static constexpr std::size_t opened = alike, swept = opened + 1;
    static constexpr std::size_t count = swept + (Motion::shifts ? 1 : 0);

    template<class Numbers> static FluxSums<D> read(const Numbers& numbers)
    {
        FluxSums<D> sums;
        sums.mass = numbers[mass];
        for (int a = 0; a < D; ++a) {
            sums.by_mass[a] = numbers[by_mass + static_cast<std::size_t>(a)];
            sums.by_pressure[a] = numbers[by_pressure + static_cast<std::size_t>(a)];
        }
        sums.dilation = numbers[opened];
        if constexpr (Motion::dilates) sums.dilation += numbers[dilation];
        if constexpr (Motion::shifts) sums.swept = numbers[swept];
        return sums;
    }
};

/// The faces between the particles of a batch of rows and their neighbours, in packs. The work is split in three loops over
/// the packs: each pack is a long chain of dependent operations, and a processor overlaps the chains of several packs
/// where the loops are short in code and long in turns.
template<int D, class AnyLimiter, class Motion, class Area> class FaceBatch {
public:
    FaceBatch(const PairRecords<D>& records, std::size_t longest_row, const FluidModel<D>& model, AnyLimiter limiter,
              Motion motion, std::span<std::byte> scratch)
        : records_(records),
          model_(model),
          limiter_(limiter),
          motion_(motion),
          pairs_(longest_row),
          faces_(pairs_.most_packs()),
          sums_(records.size(), pairs_.most_packs(), scratch)
    {}

    /// The faces to be solved next.
    PairBatch& pairs() { return pairs_; }

    /// 1. Reconstructs the faces. 2. Solves the Riemann problems. 3. Sums what crosses the faces of each particle, to
    /// row k of `sums`. The batch is empty then.
    void solve(FluxField<D>& sums)
    {
        for (std::size_t n = 0; n < pairs_.packs(); ++n) reconstruct(faces_[n], pairs_.owners(n), pairs_.others(n));
        std::visit([this](auto riemann) { solve_riemann_problems(riemann); }, model_.riemann);
        for (std::size_t n = 0; n < pairs_.packs(); ++n) sums_.put(n, crossing(faces_[n]));
        sums_.sum(pairs_, [&](std::size_t k, const auto& numbers) { sums[k] = Places::read(numbers); });
        pairs_.clear();
    }

private:
    using Places = FluxPlaces<D, Motion, Area>;
    using Sums = PairSums<Places::count, Places::alike>;
    static constexpr std::size_t slope_size = PairRecords<D>::slope_size;

    /// A pack of faces, as each loop leaves them to the next.
    struct Faces {
        FaceFrame<D, Pack> frame;
        FaceStates<Pack> sides;
        StarState<Pack> star;
        Pack strength;                 ///< S = 2 w_i w_j |W'| [m^(D-1)]
        FaceShift<Pack> shift;         ///< where particles are shifted
        std::array<Pack, D> direction; ///< where areas are renormalised: (K_i + K_j)/2 x_ij [m]
        Pack opening;                  ///< (v_j - v_i)/2 . direction, else . x_ij [m^2/s]
    };

    [[gnu::always_inline]] inline void reconstruct(Faces& faces, const PackOwners& owners, const int* others) const
    {
        const auto state_of = [this](int i) { return records_.state(i); };
        const auto slope_of = [this](int i) { return records_.slope(i); };
        const auto state_i = owners.columns<8>(state_of), state_j = load_columns<8>(state_of, others);
        const auto slope_i = owners.columns<slope_size>(slope_of), slope_j = load_columns<slope_size>(slope_of, others);
        PairView<D, Pack> pair;
        std::array<Pack, D> mean_velocity;
        for (std::size_t a = 0; a < D; ++a) {
            pair.x[a] = state_j[a] - state_i[a];
            pair.velocity_jump[a] = state_j[D + a] - state_i[D + a];
            mean_velocity[a] = 0.5 * (state_j[D + a] + state_i[D + a]);
        }
        for (std::size_t a = 0; a < D; ++a) {
            pair.velocity_slope_i[a] = along(&slope_i[D + a * D], pair.x);
            pair.velocity_slope_j[a] = along(&slope_j[D + a * D], pair.x);
        }
        const Pack r = square_root(dot(pair.x, pair.x) + 1e-300);
        pair.inverse_distance = 1.0 / r;
        faces.strength = (state_i[2 * D + 1] * state_j[2 * D + 1]) * (2.0 * model_.kernel.slope(r));
        const RatioView<Pack> q{state_i[2 * D], state_j[2 * D], along(&slope_i[0], pair.x), along(&slope_j[0], pair.x)};
        faces.sides = reconstruct_face(pair, q, 1.0 / model_.eos.c0, limiter_);
        if constexpr (Motion::shifts) faces.shift = face_shift(owners, others, pair);
        if constexpr (Area::renormalises)
            faces.direction = direction(pair, records_.area_of(state_i, slope_i), records_.area_of(state_j, slope_j));
        faces.opening = 0.5 * dot(pair.velocity_jump, Area::renormalises ? faces.direction : pair.x);
        faces.frame = face_frame<D>(pair, mean_velocity);
    }

    [[gnu::always_inline]] static inline std::array<Pack, D> direction(const PairView<D, Pack>& pair,
                                                                       const SymmetricPacks<D>& area_i,
                                                                       const SymmetricPacks<D>& area_j)
    {
        SymmetricPacks<D> twice; // K_i + K_j
        for (std::size_t n = 0; n < twice.size(); ++n) twice[n] = area_i[n] + area_j[n];
        std::array<Pack, D> half, result;
        for (std::size_t a = 0; a < D; ++a) half[a] = 0.5 * pair.x[a];
        for (std::size_t a = 0; a < D; ++a) {
            result[a] = twice[upper_triangle<D>(a, 0)] * half[0];
            for (std::size_t b = 1; b < D; ++b)
                result[a] = multiply_add(twice[upper_triangle<D>(a, b)], half[b], result[a]);
        }
        return result;
    }

    FaceShift<Pack> face_shift(const PackOwners& owners, const int* others, const PairView<D, Pack>& pair) const
    {
        const auto shift_of = [this](int i) { return records_.shift(i); };
        const auto shift_i = owners.columns<D>(shift_of);
        const auto shift_j = load_columns<8>(shift_of, others);
        Pack sum{}, jump{};
        for (std::size_t a = 0; a < D; ++a) {
            sum += (shift_j[a] + shift_i[a]) * pair.x[a];
            jump += (shift_j[a] - shift_i[a]) * pair.x[a];
        }
        const Pack half = 0.5 * pair.inverse_distance;
        return {half * sum, half * jump};
    }

    template<class AnyRiemann> void solve_riemann_problems(AnyRiemann riemann)
    {
        for (std::size_t n = 0; n < pairs_.packs(); ++n) faces_[n].star = riemann(faces_[n].sides);
    }

    /// What the neighbours get through a pack of faces.
    [[gnu::always_inline]] inline std::array<Pack, Sums::size> crossing(const Faces& faces) const
    {
        const Tait& eos = model_.eos;
        std::array<Pack, Sums::size> columns{};
        const auto transport = motion_(eos.c0 * faces.star.u, faces.shift);
        const Pack per_length = faces.strength * faces.frame.inverse_distance;
        const Pack pressure = eos.pressure_at_ratio(faces.star.q) * per_length;
        const auto& direction = Area::renormalises ? faces.direction : faces.frame.x;
        for (std::size_t a = 0; a < D; ++a) columns[Places::by_pressure + a] = pressure * direction[a];
        if constexpr (Motion::exchanges_mass) {
            const auto velocity = face_velocity(faces.frame, transport.relative, limiter_);
            const Pack mass = faces.strength * (eos.rho0 * faces.star.q * transport.relative);
            columns[Places::mass] = mass;
            for (std::size_t a = 0; a < D; ++a) columns[Places::by_mass + a] = mass * velocity[a];
        }
        if constexpr (Motion::dilates) columns[Places::dilation] = -(faces.strength * transport.dilation);
        columns[Places::opened] = per_length * faces.opening;
        if constexpr (Motion::shifts) columns[Places::swept] = faces.strength * transport.swept;
        return columns;
    }

    const PairRecords<D>& records_;
    const FluidModel<D> model_;
    const AnyLimiter limiter_;
    const Motion motion_;
    PairBatch pairs_;
    std::vector<Faces> faces_;
    Sums sums_;
};

} // namespace sph

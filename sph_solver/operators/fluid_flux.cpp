// SPDX-License-Identifier: MIT
#include "sph_solver/operators/fluid_flux.hpp"

#include "sph_solver/numerics/muscl.hpp"

namespace sph {
namespace {

/// The same sums as FluxSums, eight neighbours side by side: mass, by_mass, by_pressure, volume,
/// dilation.
template<int D> struct FluxPacks {
    std::array<Pack, 2 * D + 3> sums{};

    [[gnu::always_inline]] inline void write(FluxSums<D>& result) const
    {
        const auto total = sum_lanes_of(sums);
        result.mass = total[0];
        for (std::size_t a = 0; a < D; ++a) {
            result.by_mass[static_cast<int>(a)] = total[1 + a];
            result.by_pressure[static_cast<int>(a)] = total[1 + D + a];
        }
        result.volume = total[1 + 2 * D];
        result.dilation = total[2 + 2 * D];
    }
};

/// Sum of a[k] x[k]: a gradient's prediction along the pairs. `Row` is a row of numbers or of packs.
template<int D, class Row> [[gnu::always_inline]] inline Pack along(const Row* gradient, const std::array<Pack, D>& x)
{
    Pack sum = gradient[0] * x[0];
    for (std::size_t b = 1; b < D; ++b) sum = multiply_add(gradient[b] + Pack{}, x[b], sum);
    return sum;
}

/// The faces of a batch of particles towards their neighbours, eight in a pack. The work is split in three loops over
/// the packs: each pack is a long chain of dependent operations, and a processor overlaps the chains of several packs
/// where the loops are short in code and long in turns.
template<int D> class FaceBatch {
public:
    FaceBatch(const PairRecords<D>& records, const ReachedNeighbours& neighbours, const FluidModel<D>& model)
        : records_(records), model_(model)
    {
        const std::size_t capacity = filled + neighbours.longest / pack_size;
        frames_.resize(capacity);
        shifts_.resize(capacity);
        areas_.resize(capacity);
        dilations_.resize(capacity);
        area_.resize(capacity);
        faces_.resize(capacity);
        stars_.resize(capacity);
    }

    /// 1. Reconstructs the faces of particle i, whose sums go to `sums` when the batch is solved.
    template<class AnyLimiter, class Motion, class Area>
    void reconstruct(int i, std::span<const int> neighbours, FluxSums<D>& sums, AnyLimiter limiter, Motion motion,
                     Area)
    {
        const double* state = records_.state(i);
        const double* slope = records_.slope(i);
        for (std::size_t n = 0; n < neighbours.size(); n += pack_size)
            {
            if constexpr (Area::renormalises) renormalise(i, &neighbours[n]);
            reconstruct_pack(state, slope, &neighbours[n], limiter, motion);
        }
        rows_[row_count_++] = {&sums, size_};
    }

    bool full() const { return size_ >= filled || row_count_ == rows_.size(); }

    /// 2. Solves the Riemann problems. 3. Sums what crosses the faces of each particle. The batch is empty then.
    template<class AnyLimiter, class Motion, class Area> void solve(AnyLimiter limiter, Motion motion, Area area)
    {
        std::visit([this](auto riemann) { solve_riemann_problems(riemann); }, model_.riemann);
        std::size_t n = 0;
        for (std::size_t row = 0; row < row_count_; ++row) {
            FluxPacks<D> packs;
            for (; n < rows_[row].end; ++n) add_pack(packs, n, limiter, motion, area);
            packs.write(*rows_[row].sums);
        }
        size_ = 0;
        row_count_ = 0;
    }

private:
    static constexpr std::size_t filled = 40; // packs: the batch stays within the first-level cache

    struct Row {
        FluxSums<D>* sums = nullptr;
        std::size_t end = 0; // one past its last pack
    };

    template<class AnyLimiter, class Motion>
    [[gnu::always_inline]] inline void reconstruct_pack(const double* state_i, const double* slope_i,
                                                        const int* indices, AnyLimiter limiter, Motion)
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
            pair.velocity_slope_i[a] = along<D>(slope_i + D + a * D, pair.x);
            pair.velocity_slope_j[a] = along<D>(slope.data() + D + a * D, pair.x);
        }
        const Pack r = square_root(dot(pair.x, pair.x) + 1e-300);
        pair.inverse_distance = 1.0 / r;
        area_[size_] = (state_i[2 * D + 1] * state[2 * D + 1]) * (2.0 * model_.kernel.slope(r));
        const RatioView<Pack> q{Pack{} + state_i[2 * D], state[2 * D], along<D>(slope_i, pair.x),
                                along<D>(slope.data(), pair.x)};
        faces_[size_] = reconstruct_face(pair, q, 1.0 / model_.eos.c0, limiter);
        if constexpr (Motion::shifts) shifts_[size_] = face_shift(slope_i, slope, pair);
        frames_[size_++] = face_frame<D>(pair, mean_velocity);
    }

    /// (K_i + K_j)/2 x_ij of the next pack, and (v_j - v_i)/2 . ((K_i + K_j)/2 - I) x_ij.
    [[gnu::always_inline]] inline void renormalise(int i, const int* indices)
    {
        const double* area_i = records_.area(i);
        const double* state_i = records_.state(i);
        const auto area = load_columns<PairRecords<D>::area_size>([this](int j) { return records_.area(j); }, indices);
        const auto state = load_columns<8>([this](int j) { return records_.state(j); }, indices);
        auto& along_area = areas_[size_];
        Pack dilation{};
        for (std::size_t a = 0; a < D; ++a) {
            along_area[a] = Pack{};
            for (std::size_t b = 0; b < D; ++b)
                along_area[a] += (area[a * D + b] + area_i[a * D + b]) * (0.5 * (state[b] - state_i[b]));
            dilation += (state[D + a] - state_i[D + a]) * (along_area[a] - (state[a] - state_i[a]));
        }
        dilations_[size_] = 0.5 * dilation;
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
        for (std::size_t n = 0; n < size_; ++n) stars_[n] = riemann(faces_[n]);
    }

    template<class AnyLimiter, class Motion, class Area>
    [[gnu::always_inline]] inline void add_pack(FluxPacks<D>& packs, std::size_t n, AnyLimiter limiter, Motion motion,
                                                Area) const
    {
        const Tait& eos = model_.eos;
        const FaceFrame<D, Pack>& frame = frames_[n];
        const auto transport = motion(eos.c0 * stars_[n].u, shifts_[n]);
        const Pack pressure = area_[n] * eos.pressure_at_ratio(stars_[n].q) * frame.inverse_distance;
        auto& sums = packs.sums;
        const auto& along_area = Area::renormalises ? areas_[n] : frame.x;
        for (std::size_t a = 0; a < D; ++a) sums[1 + D + a] = multiply_add(-pressure, along_area[a], sums[1 + D + a]);
        if constexpr (Area::renormalises) sums[2 + 2 * D] = multiply_add(area_[n] * frame.inverse_distance, dilations_[n], sums[2 + 2 * D]);
        if constexpr (Motion::sweeps_volume) sums[1 + 2 * D] = multiply_add(area_[n], transport.sweep, sums[1 + 2 * D]);
        if constexpr (Motion::exchanges_mass) {
            const auto velocity = face_velocity(frame, transport.relative, limiter);
            const Pack mass_flux = area_[n] * (eos.rho0 * stars_[n].q * transport.relative);
            sums[0] -= mass_flux;
            for (std::size_t a = 0; a < D; ++a) sums[1 + a] = multiply_add(-mass_flux, velocity[a], sums[1 + a]);
        }
    }

    const PairRecords<D>& records_;
    const FluidModel<D> model_;
    std::size_t size_ = 0, row_count_ = 0;
    std::array<Row, 32> rows_;
    std::vector<FaceFrame<D, Pack>> frames_;
    std::vector<FaceShift<Pack>> shifts_;
    std::vector<std::array<Pack, D>> areas_; ///< renormalised ones along n, times |x_ij|
    std::vector<Pack> dilations_;
    std::vector<Pack> area_;
    std::vector<FaceStates<Pack>> faces_;
    std::vector<StarState<Pack>> stars_;
};

template<int D, class AnyLimiter, class Motion, class Area>
void sum_fluxes(FluxField<D>& sums, const PairRecords<D>& records, const ReachedNeighbours& neighbours,
                const RowSet& rows, const FluidModel<D>& model, AnyLimiter limiter, Motion motion, Area area)
{
    if (rows.size() == 0) return;
    FaceBatch<D> batch(records, neighbours, model);
    rows.for_each([&](std::size_t k, int i) {
        batch.reconstruct(i, neighbours.packs_of(k), sums[k], limiter, motion, area);
        if (batch.full()) batch.solve(limiter, motion, area);
    });
    batch.solve(limiter, motion, area);
}

} // namespace

template<int D>
void add_fluid_fluid_flux(Rates<D>& rates, FluxField<D>& sums, const PairRecords<D>& records,
                          const ReachedNeighbours& neighbours, const RowSet& rows, const FluidModel<D>& model)
{
    sums.resize(rows.all());
    std::visit(
        [&](auto limiter, auto motion, auto area) {
            sum_fluxes(sums, records, neighbours, rows, model, limiter, motion, area);
        },
        model.limiter, model.face_motion, model.pair_area);
    rows.for_each([&](std::size_t k, int particle) {
        const auto i = static_cast<std::size_t>(particle);
        rates.mass[i] += sums[k].mass;
        rates.volume[i] += sums[k].volume + sums[k].dilation;
        rates.momentum[i] += sums[k].by_mass + sums[k].by_pressure;
    });
}

template<int D> void add_gravity(Rates<D>& rates, const Particles<D>& particles, const Vec<D>& gravity)
{
    for (const int owned : particles.owned) {
        const auto i = static_cast<std::size_t>(owned);
        rates.momentum[i] += particles.mass[i] * gravity;
    }
}

template void add_fluid_fluid_flux<2>(Rates<2>&, FluxField<2>&, const PairRecords<2>&, const ReachedNeighbours&,
                                      const RowSet&, const FluidModel<2>&);
template void add_fluid_fluid_flux<3>(Rates<3>&, FluxField<3>&, const PairRecords<3>&, const ReachedNeighbours&,
                                      const RowSet&, const FluidModel<3>&);
template void add_gravity<2>(Rates<2>&, const Particles<2>&, const Vec<2>&);
template void add_gravity<3>(Rates<3>&, const Particles<3>&, const Vec<3>&);

} // namespace sph

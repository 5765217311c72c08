// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/pack_columns.hpp"

#include <algorithm>
#include <cstddef>
#include <memory_resource>
#include <span>
#include <vector>

namespace sph {

/// Whose pairs a pack holds: the first lanes belong to one particle, the others to the next.
struct PackOwners {
    int first = 0, second = 0;
    std::size_t split = pack_lanes; ///< lanes of the first

    /// Numbers of the owners, lane by lane; row(i) is where those of particle i begin.
    template<std::size_t Size, class Row> [[gnu::always_inline]] inline std::array<Pack, Size> columns(Row row) const
    {
        const double *const a = row(first), *const b = row(second);
        const Lanes lanes = first_lanes(split);
        std::array<Pack, Size> columns;
        unrolled<Size>([&](auto c) __attribute__((always_inline)) {
            columns[c] = choose(lanes, everywhere(a[c]), everywhere(b[c]));
        });
        return columns;
    }
};

/// The pairs of some particles, one row after the other, in packs that a row may share with the next one: rows of ten
/// neighbours would leave a third of the lanes empty. Free lanes hold a pair of a particle with itself.
class PairBatch {
public:
    struct Row {
        int particle = 0;
        std::size_t k = 0;     ///< its number among the owned particles
        std::size_t begin = 0; ///< its first pair
        std::size_t own = 0;   ///< so many pairs that only this particle is to hear of
        std::size_t end = 0;   ///< one past its last pair
    };

    explicit PairBatch(std::size_t longest_row)
        : others_(whole_units(target + longest_row) + 4 * row_unit), owners_(others_.size() / pack_lanes)
    {}

    /// Where the pairs of the next row are to be written: room for the longest one and four units more.
    [[nodiscard]] int* next() { return &others_[next_begin()]; }

    /// Takes what was written there as the pairs of particle i: `own` of them, and then `shared`, whose other particle hears
    /// of them as well.
    void take(int i, std::size_t k, std::size_t own, std::size_t shared)
    {
        const std::size_t begin = own + shared == 0 ? size_ : next_begin();
        rows_.push_back({i, k, begin, own, begin + own + shared});
        if (own + shared > 0) {
            if (begin % pack_lanes != 0) owners_[packs() - 1] = {owners_[packs() - 1].first, i, begin % pack_lanes};
            const std::size_t owned = (begin + pack_lanes - 1) / pack_lanes;
            size_ = begin + own + shared;
            for (std::size_t pack = owned; pack < packs(); ++pack) owners_[pack] = {i, i, pack_lanes};
        }
        if (size_ > 0) fill_free_lanes();
    }

    /// Appends the pairs of particle i with `own` and then those with `shared`, which hear of them as well.
    void add(int i, std::size_t k, std::span<const int> own, std::span<const int> shared)
    {
        std::copy(shared.begin(), shared.end(), std::copy(own.begin(), own.end(), next()));
        take(i, k, own.size(), shared.size());
    }

    [[nodiscard]] bool full() const { return size_ >= target; }

    [[nodiscard]] std::size_t most_packs() const { return owners_.size(); }

    void clear()
    {
        size_ = 0;
        rows_.clear();
    }

    [[nodiscard]] std::size_t packs() const { return (size_ + pack_lanes - 1) / pack_lanes; }
    [[nodiscard]] const PackOwners& owners(std::size_t pack) const { return owners_[pack]; }
    /// The neighbours of a pack's pairs.
    [[nodiscard]] const int* others(std::size_t pack) const { return &others_[pack * pack_lanes]; }
    [[nodiscard]] int other(std::size_t pair) const { return others_[pair]; }
    [[nodiscard]] std::span<const Row> rows() const { return rows_; }

private:
    static constexpr std::size_t target = 192; // pairs: the batch stays within the nearest caches

    /// A pack has two owners at most: the third one's row begins with the next pack.
    [[nodiscard]] std::size_t next_begin() const
    {
        const bool shared = size_ % pack_lanes != 0 && owners_[packs() - 1].split < pack_lanes;
        return shared ? packs() * pack_lanes : size_;
    }

    void fill_free_lanes()
    {
        const int last = owners_[packs() - 1].second;
        for (std::size_t pair = size_; pair < packs() * pack_lanes; ++pair) others_[pair] = last;
    }

    std::size_t size_ = 0; ///< pairs, with the free lanes between rows
    std::vector<int> others_;
    std::vector<PackOwners> owners_;
    std::vector<Row> rows_;
};

/// Sums of `count` numbers over the pairs of each particle. A pair is computed once: its owner gets the opposite of the
/// first `opposite` numbers and the others as they are; the other particle gets all of them as they are. A sum takes the
/// pairs with the neighbours before a particle one by one, in order, and those with the ones behind it in two
/// parts in turn, whoever has computed them: so its bits do not depend on which particles have a row.
template<std::size_t count, std::size_t opposite> class PairSums {
public:
    static constexpr std::size_t size = (count + 7) / 8 * 8;

    /// Whole cache lines.
    struct alignas(64) Numbers {
        std::array<double, size> data{};
        double operator[](std::size_t n) const { return data[n]; }
    };

    /// \param scratch memory for what the particles receive; what does not fit there comes from the system
    PairSums(std::size_t particles, std::size_t most_packs, std::span<std::byte> scratch = {})
        : memory_(scratch.data(), scratch.size()), received_(particles, &memory_), of_pairs_(most_packs * pack_lanes)
    {}

    /// Takes the numbers of a pack's pairs, as the other particle gets them.
    [[gnu::always_inline]] inline void put(std::size_t pack, const std::array<Pack, size>& columns)
    {
        for (std::size_t begin = 0; begin < size; begin += 8) {
            std::array<Pack, 8> part;
            for (std::size_t n = 0; n < 8; ++n) part[n] = columns[begin + n];
            store_rows(part, [&](std::size_t lane) { return &of_pairs_[pack * pack_lanes + lane].data[begin]; });
        }
    }

    /// Sums the batch's rows, in order. Calls take(k, numbers) for each.
    template<class Take> void sum(const PairBatch& batch, Take take)
    {
        for (const PairBatch::Row& row : batch.rows()) {
            Accumulator first, second;
            if (row.own == 0) first.start(received_[static_cast<std::size_t>(row.particle)]);
            std::size_t pair = row.begin;
            for (; pair < row.begin + row.own; ++pair) first.add(of_pairs_[pair]);
            const auto share = [&](Accumulator& mine, std::size_t n) {
                mine.add(of_pairs_[n]);
                add(received_[static_cast<std::size_t>(batch.other(n))], of_pairs_[n]);
            };
            for (; pair + 1 < row.end; pair += 2) {
                share(first, pair);
                share(second, pair + 1);
            }
            if (pair < row.end) share(first, pair);
            take(row.k, first.and_of(second));
        }
    }

private:
    static constexpr std::size_t packs = size / pack_lanes;

    /// The owner's sum, in registers.
    class Accumulator {
    public:
        void start(const Numbers& from)
        {
            each([&](auto n) { sum_[n] = load_pack(&from.data[n * pack_lanes]); });
        }
        void add(const Numbers& pair)
        {
            each([&](auto n) {
                sum_[n] = multiply_add(load_pack(&pair.data[n * pack_lanes]), load_pack(&signs.data[n * pack_lanes]),
                                       sum_[n]);
            });
        }
        [[nodiscard]] Numbers and_of(const Accumulator& other) const
        {
            Numbers numbers;
            each([&](auto n) { store_pack(&numbers.data[n * pack_lanes], sum_[n] + other.sum_[n]); });
            return numbers;
        }

    private:
        template<class Visit> [[gnu::always_inline]] static inline void each(Visit visit) { unrolled<packs>(visit); }
        static constexpr Numbers signs = [] {
            Numbers numbers;
            for (std::size_t n = 0; n < size; ++n) numbers.data[n] = n < opposite ? -1.0 : 1.0;
            return numbers;
        }();
        std::array<Pack, packs> sum_{};
    };

    static void add(Numbers& to, const Numbers& pair)
    {
        unrolled<packs>([&](auto n) { add_pack(&to.data[n * pack_lanes], load_pack(&pair.data[n * pack_lanes])); });
    }

    std::pmr::monotonic_buffer_resource memory_;
    std::pmr::vector<Numbers> received_; ///< by each local particle from the pairs before its own row
    std::vector<Numbers> of_pairs_;
};

} // namespace sph

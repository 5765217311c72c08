// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/neighbour_list.hpp"
#include "sph_solver/numerics/pack_columns.hpp"
#include "sph_solver/numerics/vector.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

/// \file
/// Which of many points are close to one? Pack are compared at a time; the indices of those that pass are packed to
/// the left in a register where the processor can (AVX-512, AVX2), else one by one. Nothing but speed depends on it.
namespace sph {

/// What a selection may write beyond the last index that it keeps.
inline constexpr std::size_t selection_overhang = 2 * row_unit;

using PackIndices = int __attribute__((vector_size(pack_lanes * sizeof(int))));

/// Row m holds the places of the bits of m, ascending: what goes where when four are packed to the left.
inline constexpr auto left_packed = [] {
    std::array<std::array<int, 4>, 16> table{};
    for (std::size_t mask = 0; mask < 16; ++mask)
        for (int bit = 0, place = 0; bit < 4; ++bit)
            if ((mask >> bit & 1) != 0) table[mask][static_cast<std::size_t>(place++)] = bit;
    return table;
}();

/// The lanes whose number is below the limit, one bit each.
[[gnu::always_inline]] inline unsigned lanes_below(Pack number, double limit)
{
#if defined(__AVX512F__)
    return _mm512_cmp_pd_mask(number, _mm512_set1_pd(limit), _CMP_LT_OQ);
#elif defined(__AVX__)
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(number, _mm256_set1_pd(limit), _CMP_LT_OQ)));
#else
    unsigned bits = 0;
    for (std::size_t lane = 0; lane < pack_lanes; ++lane) bits |= static_cast<unsigned>(number[lane] < limit) << lane;
    return bits;
#endif
}

/// Writes those of a pack of indices whose bit is set to `out`, packed to the left; always writes a pack. Returns the end of
/// what it has kept.
[[gnu::always_inline]] inline int* keep_marked(int* out, PackIndices indices, unsigned bits)
{
#if defined(__AVX512F__) && defined(__AVX512VL__)
    const auto kept = _mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), reinterpret_cast<__m256i>(indices));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), kept);
    return out + __builtin_popcount(bits);
#elif defined(__AVX2__)
    __m128i places;
    std::memcpy(&places, left_packed[bits].data(), sizeof places);
    const auto lanes = _mm_castsi128_ps(reinterpret_cast<__m128i>(indices));
    _mm_storeu_ps(reinterpret_cast<float*>(out), _mm_permutevar_ps(lanes, places));
    return out + __builtin_popcount(bits);
#else
    for (std::size_t lane = 0; lane < pack_lanes; ++lane) {
        *out = indices[lane];
        out += bits >> lane & 1;
    }
    return out;
#endif
}

/// Where the selection of a row stands: the end of what it has kept, and how many of these are less than i.
struct Taken {
    int* end;
    int before = 0;
};

/// Writes those of a block of neighbours to `taken.end` that are marked (PointRows::mark); the block's first entry has the bit
/// number `first`. `behind`: it keeps none that are less than i.
/// \pre room for as many indices and the overhang; three bytes more behind the bits
template<bool behind = false>
[[gnu::always_inline]] inline void take_marked(Taken& taken, const NeighbourBlock& block, const std::uint8_t* bits,
                                               int first, int i)
{
    const auto marks_of = [&](int n, int most) {
        std::uint32_t marks;
        std::memcpy(&marks, bits + (first + n) / 8, sizeof marks);
        return marks >> ((first + n) % 8) & ((1U << std::min(most, block.count - n)) - 1);
    };
#if defined(__AVX512F__)
    const __m512i own = _mm512_set1_epi32(i), base = _mm512_set1_epi32(block.base);
    for (int n = 0; n < block.count; n += 16) {
        auto kept = static_cast<__mmask16>(marks_of(n, 16));
        __m256i words;
        std::memcpy(&words, block.offsets + n, sizeof words);
        const __m512i indices =
            _mm512_mask_add_epi32(base, 0xffff, base, _mm512_mask_cvtepu16_epi32(base, 0xffff, words));
        if constexpr (behind)
            kept = _mm512_mask_cmpgt_epi32_mask(kept, indices, own);
        else
            taken.before += __builtin_popcount(_mm512_mask_cmplt_epi32_mask(kept, indices, own));
        _mm512_storeu_si512(taken.end, _mm512_maskz_compress_epi32(kept, indices));
        taken.end += __builtin_popcount(kept);
    }
#else
    using PackWords = std::uint16_t __attribute__((vector_size(pack_lanes * sizeof(std::uint16_t))));
    int* const begin = taken.end;
    for (int n = 0; n < block.count; n += static_cast<int>(pack_lanes)) {
        PackWords words;
        std::memcpy(&words, block.offsets + n, sizeof words);
        const PackIndices indices = __builtin_convertvector(words, PackIndices) + block.base;
        taken.end = keep_marked(taken.end, indices, marks_of(n, static_cast<int>(pack_lanes)));
    }
    const auto before = static_cast<int>(std::count_if(begin, taken.end, [i](int j) { return j < i; }));
    if constexpr (behind)
        taken.end = std::copy(begin + before, taken.end, begin);
    else
        taken.before += before;
#endif
}

/// Points in columns: for candidates that lie one after the other.
template<int D> class PointColumns {
public:
    void load(const std::vector<Vec<D>>& points)
    {
        for (std::size_t d = 0; d < D; ++d) columns_[d].resize(points.size() + row_unit);
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t d = 0; d < D; ++d) columns_[d][i] = points[i][static_cast<int>(d)];
    }

    /// Writes the j != i of the range begin <= j < end with |x_j - x_i|^2 < limit to `out`, ascending. Returns the end
    /// of what it has kept. \pre room for end - begin + overhang indices
    int* select(int i, double limit, int begin, int end, int* out) const
    {
        std::array<const double*, D> column;
        std::array<double, D> x_i;
        for (std::size_t d = 0; d < D; ++d) {
            column[d] = columns_[d].data();
            x_i[d] = column[d][i];
        }
        for (int j = begin; j < end; j += static_cast<int>(pack_lanes)) {
            Pack square{};
            for (std::size_t d = 0; d < D; ++d) {
                const Pack x = load_pack(column[d] + j) - x_i[d];
                square = d == 0 ? x * x : square + x * x;
            }
            const int own = i - j, left = end - j; // lanes
            unsigned kept = lanes_below(square, limit);
            if (left < static_cast<int>(pack_lanes)) kept &= (1U << left) - 1;
            if (own >= 0 && own < static_cast<int>(pack_lanes)) kept &= ~(1U << own);
            out = keep_marked(out, counted + j, kept);
        }
        return out;
    }

private:
#if defined(__AVX512F__)
    static constexpr PackIndices counted = {0, 1, 2, 3, 4, 5, 6, 7};
#else
    static constexpr PackIndices counted = {0, 1, 2, 3};
#endif
    std::array<std::vector<double>, D> columns_;
};

/// Points in rows: for candidates that lie here and there.
template<int D> class PointRows {
public:
    void resize(std::size_t count) { rows_.resize(count); }
    void set(int i, const Vec<D>& point)
    {
        for (int d = 0; d < D; ++d) rows_[static_cast<std::size_t>(i)].x[d] = point[d];
    }
    void load(const std::vector<Vec<D>>& points)
    {
        resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) set(static_cast<int>(i), points[i]);
    }

    /// Marks those of a list that have |x_j - x_i|^2 < limit: bit n % 8 of byte n / 8 stands for its entry n; further bits of
    /// the last byte mean nothing. \pre a unit of indices behind the list, in range
    void mark(int i, double limit, std::span<const int> listed, std::uint8_t* bits) const
    {
        for (std::size_t n = 0; n < listed.size(); n += row_unit) {
            unsigned byte = 0;
            for (std::size_t part = 0; part < row_unit; part += pack_lanes)
                byte |= lanes_below(squares(i, listed.data() + n + part), limit) << part;
            *bits++ = static_cast<std::uint8_t>(byte);
        }
    }

private:
    struct alignas(D == 2 ? 16 : 32) Row {
        double x[D == 2 ? 2 : 4] = {}; ///< zeros behind the coordinates
    };

    /// |x_j - x_i|^2 of a pack of points.
    [[gnu::always_inline]] inline Pack squares(int i, const int* j) const;
    std::vector<Row> rows_;
};

/// Two or four points in a register (x y x y ...), the even and the odd ones; their squares are then sorted in columns.
template<> inline Pack PointRows<2>::squares(int i, const int* j) const
{
    const auto row = [this](int k) { return load_two(rows_[static_cast<std::size_t>(k)].x); };
    const auto sorted = [](Pack even, Pack odd) {
        return even_lanes(even * even, odd * odd) + odd_lanes(even * even, odd * odd);
    };
    const FourNumbers from = joined(row(i), row(i));
#if defined(__AVX512F__)
    const auto four = [&](int a, int b, int c, int d) {
        return joined(joined(row(a), row(b)) - from, joined(row(c), row(d)) - from);
    };
    return sorted(four(j[0], j[2], j[4], j[6]), four(j[1], j[3], j[5], j[7]));
#else
    return sorted(joined(row(j[0]), row(j[2])) - from, joined(row(j[1]), row(j[3])) - from);
#endif
}

/// One or two points in a register (x y z 0 x y z 0); x + y and z of half of the points meet in one register.
template<> inline Pack PointRows<3>::squares(int i, const int* j) const
{
    const auto row = [this](int k) {
        FourNumbers x;
        std::memcpy(&x, rows_[static_cast<std::size_t>(k)].x, sizeof x);
        return x;
    };
    const auto half = [](Pack even, Pack odd) {
        return even_lanes(even * even, odd * odd) + odd_lanes(even * even, odd * odd);
    };
#if defined(__AVX512F__)
    const Pack from = joined(row(i), row(i));
    const auto two = [&](int a, int b) { return joined(row(j[a]), row(j[b])) - from; };
    const Pack first = half(two(0, 2), two(1, 3));
    const Pack second = half(two(4, 6), two(5, 7));
#else
    const Pack from = row(i);
    const Pack first = half(row(j[0]) - from, row(j[1]) - from);
    const Pack second = half(row(j[2]) - from, row(j[3]) - from);
#endif
    return even_pieces(first, second) + odd_pieces(first, second);
}

} // namespace sph

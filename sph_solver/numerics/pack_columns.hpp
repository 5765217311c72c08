// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/pack.hpp"

/// \file
/// From rows of numbers to packs and back: columns of rows that lie here and there, and sums over lanes.
namespace sph {

#if defined(__AVX512F__)
/// The 128-bit pieces 0 and 2 of `a`, then those of `b`; and the pieces 1 and 3.
inline Pack even_pieces(Pack a, Pack b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5, 8, 9, 12, 13); }
inline Pack odd_pieces(Pack a, Pack b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7, 10, 11, 14, 15); }
/// The even lanes of `a` and `b` in turn; and the odd ones.
inline Pack even_lanes(Pack a, Pack b) { return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14); }
inline Pack odd_lanes(Pack a, Pack b) { return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15); }
#else
inline Pack even_pieces(Pack a, Pack b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); }
inline Pack odd_pieces(Pack a, Pack b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); }
inline Pack even_lanes(Pack a, Pack b) { return __builtin_shufflevector(a, b, 0, 4, 2, 6); }
inline Pack odd_lanes(Pack a, Pack b) { return __builtin_shufflevector(a, b, 1, 5, 3, 7); }
#endif

/// Two numbers that lie side by side.
using Two = double __attribute__((vector_size(2 * sizeof(double))));
inline Two load_two(const double* from)
{
    Two two;
    std::memcpy(&two, from, sizeof(two));
    return two;
}

using FourNumbers = double __attribute__((vector_size(4 * sizeof(double))));
inline FourNumbers joined(Two low, Two high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3); }

#if defined(__AVX512F__)
inline Pack joined(FourNumbers low, FourNumbers high)
{
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// Rows and columns of eight by eight numbers, exchanged.
[[gnu::always_inline]] inline std::array<Pack, 8> transposed(const std::array<Pack, 8>& row)
{
    std::array<Pack, 8> pair, four, out;
    for (std::size_t k = 0; k < 4; ++k) { // columns 2m and 2m + 1 of rows 2k and 2k + 1, in piece m
        pair[2 * k] = even_lanes(row[2 * k], row[2 * k + 1]);
        pair[2 * k + 1] = odd_lanes(row[2 * k], row[2 * k + 1]);
    }
    for (std::size_t k = 0; k < 2; ++k) { // columns {0, 4} and {2, 6} of rows 4k..4k + 3; and their odd neighbours
        for (std::size_t odd = 0; odd < 2; ++odd) {
            four[4 * k + odd] = even_pieces(pair[4 * k + odd], pair[4 * k + 2 + odd]);
            four[4 * k + 2 + odd] = odd_pieces(pair[4 * k + odd], pair[4 * k + 2 + odd]);
        }
    }
    for (std::size_t c = 0; c < 4; ++c) {
        out[c] = even_pieces(four[c], four[4 + c]);
        out[c + 4] = odd_pieces(four[c], four[4 + c]);
    }
    return out;
}

/// Eight columns of eight rows: out[c] holds component c of the rows 0..7.
[[gnu::always_inline]] inline std::array<Pack, 8> eight_columns(const std::array<const double*, 8>& row)
{
    std::array<Pack, 8> rows;
    for (std::size_t k = 0; k < 8; ++k) rows[k] = load_pack(row[k]);
    return transposed(rows);
}

/// Writes the rows 0..7 of eight columns, each to place(k).
template<class Place> [[gnu::always_inline]] inline void store_rows(const std::array<Pack, 8>& column, Place place)
{
    const auto row = transposed(column);
    for (std::size_t k = 0; k < 8; ++k) store_pack(place(k), row[k]);
}
#else
/// Eight columns of four rows, two at a time: out[c] holds component c of the rows 0..3.
[[gnu::always_inline]] inline std::array<Pack, 8> eight_columns(const std::array<const double*, 4>& row)
{
    std::array<Pack, 8> out;
    for (std::size_t c = 0; c < 8; c += 2) {
        const Pack even = joined(load_two(row[0] + c), load_two(row[2] + c));
        const Pack odd = joined(load_two(row[1] + c), load_two(row[3] + c));
        out[c] = even_lanes(even, odd);
        out[c + 1] = odd_lanes(even, odd);
    }
    return out;
}

/// Rows and columns of four by four numbers, exchanged.
[[gnu::always_inline]] inline std::array<Pack, 4> transposed(Pack a, Pack b, Pack c, Pack d)
{
    const Pack even_ab = even_lanes(a, b), odd_ab = odd_lanes(a, b);
    const Pack even_cd = even_lanes(c, d), odd_cd = odd_lanes(c, d);
    return {even_pieces(even_ab, even_cd), even_pieces(odd_ab, odd_cd), odd_pieces(even_ab, even_cd),
            odd_pieces(odd_ab, odd_cd)};
}

/// Writes the rows 0..3 of eight columns, each to place(k).
template<class Place> [[gnu::always_inline]] inline void store_rows(const std::array<Pack, 8>& column, Place place)
{
    const auto low = transposed(column[0], column[1], column[2], column[3]);
    const auto high = transposed(column[4], column[5], column[6], column[7]);
    for (std::size_t k = 0; k < 4; ++k) {
        store_pack(place(k), low[k]);
        store_pack(place(k) + 4, high[k]);
    }
}
#endif

/// Rows of as many particles as a pack has lanes, turned into columns: result[c] holds component c of the particles
/// index[0], index[1], ...; row(i) is where the row of particle i begins.
template<std::size_t Size, class Row>
[[gnu::always_inline]] inline std::array<Pack, Size> load_columns(Row row, const int* index)
{
    static_assert(Size % 8 == 0);
    std::array<const double*, pack_lanes> rows;
    for (std::size_t k = 0; k < pack_lanes; ++k) rows[k] = row(index[k]);
    std::array<Pack, Size> columns;
    for (std::size_t c = 0; c < Size; c += 8) {
        const auto part = eight_columns(rows);
        for (std::size_t k = 0; k < 8; ++k) columns[c + k] = part[k];
        for (const double*& r : rows) r += 8;
    }
    return columns;
}

/// Sums over lanes for as many packs as there are lanes: out[k] is that of a[k], always in the tree ((0 + 1) + (2 + 3)),
/// and with eight lanes ((0 + 1) + (2 + 3)) + ((4 + 5) + (6 + 7)).
[[gnu::always_inline]] inline Pack sum_lanes(const std::array<Pack, pack_lanes>& a)
{
    std::array<Pack, pack_lanes / 2> two;
    for (std::size_t k = 0; k < two.size(); ++k)
        two[k] = even_lanes(a[2 * k], a[2 * k + 1]) + odd_lanes(a[2 * k], a[2 * k + 1]);
    const Pack first = even_pieces(two[0], two[1]) + odd_pieces(two[0], two[1]);
#if defined(__AVX512F__)
    const Pack second = even_pieces(two[2], two[3]) + odd_pieces(two[2], two[3]);
    return even_pieces(first, second) + odd_pieces(first, second);
#else
    return first;
#endif
}

/// The sums of a row, apart by the parts of its units (for_each_part).
template<std::size_t N> using PartSums = std::array<std::array<Pack, N>, pack_parts>;

/// Sums of a row over lanes and parts: the tree over the entries 0..7 of its units, the same wherever registers end.
template<std::size_t N> [[gnu::always_inline]] inline std::array<double, N> sum_lanes_of(const PartSums<N>& parts)
{
    std::array<double, N> sums;
    unrolled<(N + pack_lanes - 1) / pack_lanes>([&](auto group) __attribute__((always_inline)) {
        constexpr std::size_t begin = pack_lanes * group, count = N - begin < pack_lanes ? N - begin : pack_lanes;
        std::array<Pack, pack_parts> total;
        unrolled<pack_parts>([&](auto part) __attribute__((always_inline)) {
            std::array<Pack, pack_lanes> packs{};
            unrolled<count>([&](auto k) __attribute__((always_inline)) { packs[k] = parts[part][begin + k]; });
            total[part] = sum_lanes(packs);
        });
        const Pack all = pack_parts == 1 ? total[0] : total[0] + total[pack_parts - 1];
        unrolled<count>([&](auto k) __attribute__((always_inline)) { sums[begin + k] = all[k.value]; });
    });
    return sums;
}

} // namespace sph

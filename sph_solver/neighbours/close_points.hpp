// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/pack_columns.hpp"
#include "sph_solver/numerics/vector.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

/// \file
/// Which of many points are close to one? Pack are compared at a time; the indices of those that pass are packed to
/// the left in a register where the processor can (AVX-512, AVX2), else one by one. Nothing but speed depends on it.
namespace sph {

/// What a selection may write beyond the last index that it keeps.
inline constexpr std::size_t selection_overhang = row_unit;

using PackIndices = int __attribute__((vector_size(pack_lanes * sizeof(int))));

/// Row m holds the places of the bits of m, ascending: what goes where when four are packed to the left.
inline constexpr auto left_packed = [] {
    std::array<std::array<int, 4>, 16> table{};
    for (std::size_t mask = 0; mask < 16; ++mask)
        for (int bit = 0, place = 0; bit < 4; ++bit)
            if ((mask >> bit & 1) != 0) table[mask][static_cast<std::size_t>(place++)] = bit;
    return table;
}();

/// Where a selection stands.
struct Selected {
    int* end;       ///< of the indices it has kept
    int before = 0; ///< how many of these are less than i
};

/// Writes those of the first `count` indices whose number is below the limit and which are not i; always writes a pack
/// of them.
[[gnu::always_inline]] inline void keep_below(Selected& selected, Pack number, double limit, PackIndices indices, int i,
                                              int count)
{
#if defined(__AVX512F__) && defined(__AVX512VL__)
    const auto first = static_cast<__mmask8>(count >= 8 ? 0xff : (1 << count) - 1);
    const auto lanes = reinterpret_cast<__m256i>(indices);
    const __m256i own = _mm256_set1_epi32(i);
    const __mmask8 others = _mm256_mask_cmpneq_epi32_mask(first, lanes, own);
    const __mmask8 kept = _mm512_mask_cmp_pd_mask(others, number, _mm512_set1_pd(limit), _CMP_LT_OQ);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(selected.end), _mm256_maskz_compress_epi32(kept, lanes));
    selected.end += __builtin_popcount(kept);
    selected.before += __builtin_popcount(_mm256_mask_cmplt_epi32_mask(kept, lanes, own));
#elif defined(__AVX2__)
    const auto lanes = reinterpret_cast<__m128i>(indices);
    const int first = count >= 4 ? 0xf : (1 << count) - 1;
    const int own = _mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(lanes, _mm_set1_epi32(i))));
    const int less = _mm_movemask_ps(_mm_castsi128_ps(_mm_cmplt_epi32(lanes, _mm_set1_epi32(i))));
    const int below = _mm256_movemask_pd(_mm256_cmp_pd(number, _mm256_set1_pd(limit), _CMP_LT_OQ));
    const int kept = below & first & ~own;
    __m128i places;
    std::memcpy(&places, left_packed[static_cast<std::size_t>(kept)].data(), sizeof places);
    _mm_storeu_ps(reinterpret_cast<float*>(selected.end), _mm_permutevar_ps(_mm_castsi128_ps(lanes), places));
    selected.end += __builtin_popcount(static_cast<unsigned>(kept));
    selected.before += __builtin_popcount(static_cast<unsigned>(kept & less));
#else
    for (int lane = 0; lane < std::min(count, static_cast<int>(pack_lanes)); ++lane) {
        const int kept = static_cast<int>(number[lane] < limit) & static_cast<int>(indices[lane] != i);
        *selected.end = indices[lane];
        selected.end += kept;
        selected.before += kept & static_cast<int>(indices[lane] < i);
    }
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
        Selected selected{out};
        for (int j = begin; j < end; j += static_cast<int>(pack_lanes)) {
            Pack square{};
            for (std::size_t d = 0; d < D; ++d) {
                const Pack x = load_pack(column[d] + j) - x_i[d];
                square = d == 0 ? x * x : square + x * x;
            }
            keep_below(selected, square, limit, counted + j, i, end - j);
        }
        return selected.end;
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

    /// Writes those of a list that have |x_j - x_i|^2 < limit to `out`, in its order. \pre room for as many indices and
    /// the overhang
    Selected select(int i, double limit, std::span<const int> listed, int* out) const
    {
        Selected selected{out};
        std::size_t n = 0;
        for (; n + pack_lanes <= listed.size(); n += pack_lanes) {
            PackIndices indices;
            std::memcpy(&indices, listed.data() + n, sizeof indices);
            keep_below(selected, squares(i, listed.data() + n), limit, indices, i, static_cast<int>(pack_lanes));
        }
        for (; n < listed.size(); ++n) {
            const int kept = square(i, listed[n]) < limit ? 1 : 0;
            *selected.end = listed[n];
            selected.end += kept;
            selected.before += kept & static_cast<int>(listed[n] < i);
        }
        return selected;
    }

private:
    struct alignas(D == 2 ? 16 : 32) Row {
        double x[D == 2 ? 2 : 4] = {}; ///< zeros behind the coordinates
    };

    /// |x_j - x_i|^2 of a pack of points.
    [[gnu::always_inline]] inline Pack squares(int i, const int* j) const;
    [[nodiscard]] double square(int i, int j) const
    {
        double sum = 0;
        for (int d = 0; d < D; ++d) {
            const double x = rows_[static_cast<std::size_t>(j)].x[d] - rows_[static_cast<std::size_t>(i)].x[d];
            sum += x * x;
        }
        return sum;
    }

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

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/pack.hpp"
#include "sph_solver/numerics/vector.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#if defined(__AVX512F__) && defined(__AVX512VL__)
#include <immintrin.h>
#endif

/// \file
/// Which of many points are close to one? Pack are compared at a time; the indices of those that pass are packed to
/// the left in a register where the processor can (AVX-512), else one by one. Nothing but speed depends on it.
namespace sph {

/// What a selection may write beyond the last index that it keeps.
inline constexpr std::size_t selection_overhang = pack_size;

using PackIndices = int __attribute__((vector_size(pack_size * sizeof(int))));

/// Writes those of the first `count` indices whose number is below the limit and which are not `excluded`. Returns the
/// end of what it has kept; always writes eight.
[[gnu::always_inline]] inline int* keep_below(Pack number, double limit, PackIndices indices, int excluded, int count,
                                              int* out)
{
#if defined(__AVX512F__) && defined(__AVX512VL__)
    const auto first = static_cast<__mmask8>(count >= 8 ? 0xff : (1 << count) - 1);
    const auto lanes = reinterpret_cast<__m256i>(indices);
    const __mmask8 others = _mm256_mask_cmpneq_epi32_mask(first, lanes, _mm256_set1_epi32(excluded));
    const __mmask8 kept = _mm512_mask_cmp_pd_mask(others, number, _mm512_set1_pd(limit), _CMP_LT_OQ);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_maskz_compress_epi32(kept, lanes));
    return out + __builtin_popcount(kept);
#else
    for (int lane = 0; lane < std::min(count, 8); ++lane) {
        *out = indices[lane];
        out += static_cast<int>(number[lane] < limit) & static_cast<int>(indices[lane] != excluded);
    }
    return out;
#endif
}

/// Points in columns: for candidates that lie one after the other.
template<int D> class PointColumns {
public:
    void load(const std::vector<Vec<D>>& points)
    {
        for (std::size_t d = 0; d < D; ++d) columns_[d].resize(points.size() + pack_size);
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
        for (int j = begin; j < end; j += pack_size) {
            Pack square{};
            for (std::size_t d = 0; d < D; ++d) {
                const Pack x = load_pack(column[d] + j) - x_i[d];
                square = d == 0 ? x * x : square + x * x;
            }
            out = keep_below(square, limit, PackIndices{0, 1, 2, 3, 4, 5, 6, 7} + j, i, end - j, out);
        }
        return out;
    }

private:
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

    /// Writes those of a list that have |x_j - x_i|^2 < limit to `out`, in its order. Returns the end of what it has
    /// kept. \pre room for as many indices and the overhang
    int* select(int i, double limit, std::span<const int> listed, int* out) const
    {
        std::size_t n = 0;
        for (; n + pack_size <= listed.size(); n += pack_size) {
            PackIndices indices;
            std::memcpy(&indices, listed.data() + n, sizeof indices);
            out = keep_below(squares(i, listed.data() + n), limit, indices, i, 8, out);
        }
        for (; n < listed.size(); ++n) {
            *out = listed[n];
            out += square(i, listed[n]) < limit ? 1 : 0;
        }
        return out;
    }

private:
    struct alignas(D == 2 ? 16 : 32) Row {
        double x[D == 2 ? 2 : 4] = {}; ///< zeros behind the coordinates
    };

    /// |x_j - x_i|^2 of eight points.
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

/// Four points in a register (x y x y ...), the even and the odd ones; their squares are then sorted in columns.
template<> inline Pack PointRows<2>::squares(int i, const int* j) const
{
    using Two = double __attribute__((vector_size(16)));
    const auto row = [this](int k) {
        Two x;
        std::memcpy(&x, rows_[static_cast<std::size_t>(k)].x, sizeof x);
        return x;
    };
    const auto four = [](Two a, Two b, Two c, Two d) {
        return joined(__builtin_shufflevector(a, b, 0, 1, 2, 3), __builtin_shufflevector(c, d, 0, 1, 2, 3));
    };
    const Two x_i = row(i);
    const Pack from = four(x_i, x_i, x_i, x_i);
    const Pack even = four(row(j[0]), row(j[2]), row(j[4]), row(j[6])) - from;
    const Pack odd = four(row(j[1]), row(j[3]), row(j[5]), row(j[7])) - from;
    return even_lanes(even * even, odd * odd) + odd_lanes(even * even, odd * odd);
}

/// Two points in a register (x y z 0 x y z 0), four times; x + y and z of a half of the points meet in one register.
template<> inline Pack PointRows<3>::squares(int i, const int* j) const
{
    const auto row = [this](int k) {
        HalfPack x;
        std::memcpy(&x, rows_[static_cast<std::size_t>(k)].x, sizeof x);
        return x;
    };
    const Pack from = joined(row(i), row(i));
    const auto half = [&](int a, int b, int c, int d) {
        const Pack even = joined(row(a), row(c)) - from;
        const Pack odd = joined(row(b), row(d)) - from;
        return even_lanes(even * even, odd * odd) + odd_lanes(even * even, odd * odd);
    };
    const Pack first = half(j[0], j[1], j[2], j[3]);
    const Pack second = half(j[4], j[5], j[6], j[7]);
    return even_pieces(first, second) + odd_pieces(first, second);
}

} // namespace sph

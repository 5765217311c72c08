// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

#if defined(__AVX__)
#include <immintrin.h>
#endif

/// \file
/// Eight doubles computed side by side, and the few functions that the pair formulas need of a number type.
/// Every formula of a pair is a template on its number type: `double` is the readable reference that the tests use,
/// `Pack` is what the particle loops run. Both give the same bits, on AVX2 and on AVX-512 machines: the compiler may
/// not fuse a product and a sum on its own (the project compiles with -ffp-contract=off). Where `multiply_add` fuses
/// them, changing the sign of one factor and of the summand changes the sign of the result and nothing else, which is
/// what opposite fluxes of a pair need; a sum of two products that belong to the two sides of a pair must not be fused.
namespace sph {

inline constexpr int pack_size = 8;

/// Four doubles in a register.
using HalfPack = double __attribute__((vector_size(4 * sizeof(double))));

#if defined(__AVX512F__)
/// Eight doubles. Arithmetic works lane by lane (a vector type of GCC and Clang).
using Pack = double __attribute__((vector_size(pack_size * sizeof(double))));
inline Pack joined(HalfPack low, HalfPack high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7); }
inline void set_first(Pack& a, double value) { a[0] = value; }
#else
/// Eight doubles as two times four, where no register holds eight: a vector type of that size would live in memory, and its
/// comparisons would be made one by one. Arithmetic works lane by lane.
struct Pack {
    HalfPack low, high;

    double operator[](std::size_t k) const { return k < 4 ? low[k] : high[k - 4]; }
};
inline Pack joined(HalfPack low, HalfPack high) { return {low, high}; }
inline void set_first(Pack& a, double value) { a.low[0] = value; }
inline Pack operator+(Pack a, Pack b) { return {a.low + b.low, a.high + b.high}; }
inline Pack operator-(Pack a, Pack b) { return {a.low - b.low, a.high - b.high}; }
inline Pack operator*(Pack a, Pack b) { return {a.low * b.low, a.high * b.high}; }
inline Pack operator/(Pack a, Pack b) { return {a.low / b.low, a.high / b.high}; }
inline Pack operator-(Pack a) { return {-a.low, -a.high}; }
inline Pack operator+(Pack a, double b) { return {a.low + b, a.high + b}; }
inline Pack operator-(Pack a, double b) { return {a.low - b, a.high - b}; }
inline Pack operator*(Pack a, double b) { return {a.low * b, a.high * b}; }
inline Pack operator/(Pack a, double b) { return {a.low / b, a.high / b}; }
inline Pack operator+(double a, Pack b) { return {a + b.low, a + b.high}; }
inline Pack operator-(double a, Pack b) { return {a - b.low, a - b.high}; }
inline Pack operator*(double a, Pack b) { return {a * b.low, a * b.high}; }
inline Pack operator/(double a, Pack b) { return {a / b.low, a / b.high}; }
template<class T> Pack& operator+=(Pack& a, T b) { return a = a + b; }
template<class T> Pack& operator-=(Pack& a, T b) { return a = a - b; }
template<class T> Pack& operator*=(Pack& a, T b) { return a = a * b; }
template<class T> Pack& operator/=(Pack& a, T b) { return a = a / b; }
#endif

/// Calls visit(0), ..., visit(N - 1), each with its number as a constant: a loop that the compiler has unrolled before it
/// decides what lives in registers.
template<std::size_t N, class Visit> [[gnu::always_inline]] inline void unrolled(Visit visit)
{
    [&]<std::size_t... k>(std::index_sequence<k...>) __attribute__((always_inline))
    {
        (visit(std::integral_constant<std::size_t, k>{}), ...);
    }
    (std::make_index_sequence<N>{});
}

/// Two-way names for one operation, so that a formula reads the same for `double` and for `Pack`.
inline double maximum(double a, double b) { return a > b ? a : b; }
inline double square_root(double a) { return std::sqrt(a); }
inline double select_positive(double sign, double if_positive, double otherwise)
{
    return sign > 0.0 ? if_positive : otherwise;
}

/// a b + c, rounded once where the processor can.
inline double multiply_add(double a, double b, double c)
{
#if defined(__FMA__)
    return __builtin_fma(a, b, c);
#else
    return a * b + c;
#endif
}

#if defined(__AVX512F__)
inline Pack maximum(Pack a, Pack b) // the masked form: GCC 12 warns of the plain one
{
    return _mm512_mask_max_pd(a, 0xff, a, b);
}
inline Pack square_root(Pack a) { return _mm512_mask_sqrt_pd(a, 0xff, a); }
inline Pack multiply_add(Pack a, Pack b, Pack c) { return _mm512_fmadd_pd(a, b, c); }
/// Lane by lane: `if_positive` where sign > 0, else `otherwise`.
inline Pack select_positive(Pack sign, Pack if_positive, Pack otherwise)
{
    return sign > Pack{} ? if_positive : otherwise;
}
#else
inline HalfPack square_root(HalfPack a)
{
#if defined(__AVX__)
    return _mm256_sqrt_pd(a);
#else
    for (int k = 0; k < 4; ++k) a[k] = std::sqrt(a[k]);
    return a;
#endif
}
inline HalfPack multiply_add(HalfPack a, HalfPack b, HalfPack c)
{
#if defined(__FMA__)
    return _mm256_fmadd_pd(a, b, c);
#else
    return a * b + c;
#endif
}
inline Pack maximum(Pack a, Pack b) { return {a.low > b.low ? a.low : b.low, a.high > b.high ? a.high : b.high}; }
inline Pack square_root(Pack a) { return {square_root(a.low), square_root(a.high)}; }
inline Pack multiply_add(Pack a, Pack b, Pack c)
{
    return {multiply_add(a.low, b.low, c.low), multiply_add(a.high, b.high, c.high)};
}
/// Lane by lane: `if_positive` where sign > 0, else `otherwise`.
inline Pack select_positive(Pack sign, Pack if_positive, Pack otherwise)
{
    return {sign.low > 0.0 ? if_positive.low : otherwise.low, sign.high > 0.0 ? if_positive.high : otherwise.high};
}
#endif
inline Pack maximum(Pack a, double b) { return maximum(a, Pack{} + b); }

inline Pack load_pack(const double* from)
{
    Pack pack;
    std::memcpy(&pack, from, sizeof(pack));
    return pack;
}

#if defined(__AVX512F__)
/// The 128-bit pieces 0 and 2 of `a`, then those of `b`; and the pieces 1 and 3.
inline Pack even_pieces(Pack a, Pack b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5, 8, 9, 12, 13); }
inline Pack odd_pieces(Pack a, Pack b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7, 10, 11, 14, 15); }
/// The even lanes of `a` and `b` in turn; and the odd ones.
inline Pack even_lanes(Pack a, Pack b) { return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14); }
inline Pack odd_lanes(Pack a, Pack b) { return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15); }
#else
inline Pack even_pieces(Pack a, Pack b)
{
    return {__builtin_shufflevector(a.low, a.high, 0, 1, 4, 5), __builtin_shufflevector(b.low, b.high, 0, 1, 4, 5)};
}
inline Pack odd_pieces(Pack a, Pack b)
{
    return {__builtin_shufflevector(a.low, a.high, 2, 3, 6, 7), __builtin_shufflevector(b.low, b.high, 2, 3, 6, 7)};
}
inline Pack even_lanes(Pack a, Pack b)
{
    return {__builtin_shufflevector(a.low, b.low, 0, 4, 2, 6), __builtin_shufflevector(a.high, b.high, 0, 4, 2, 6)};
}
inline Pack odd_lanes(Pack a, Pack b)
{
    return {__builtin_shufflevector(a.low, b.low, 1, 5, 3, 7), __builtin_shufflevector(a.high, b.high, 1, 5, 3, 7)};
}
#endif

/// Turns eight rows of eight numbers into eight columns: out[c] holds component c of the rows 0..7.
[[gnu::always_inline]] inline std::array<Pack, 8> transpose(const std::array<Pack, 8>& row)
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

/// Sum over the lanes, always in the same tree: ((0 + 1) + (2 + 3)) + ((4 + 5) + (6 + 7)).
inline double sum_lanes(Pack a) { return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7])); }

/// The same sum for eight packs at once, bit by bit: out[k] = sum_lanes(a[k]).
[[gnu::always_inline]] inline Pack sum_lanes(const std::array<Pack, 8>& a)
{
    std::array<Pack, 4> two;
    for (std::size_t k = 0; k < 4; ++k) two[k] = even_lanes(a[2 * k], a[2 * k + 1]) + odd_lanes(a[2 * k], a[2 * k + 1]);
    const Pack first = even_pieces(two[0], two[1]) + odd_pieces(two[0], two[1]);
    const Pack second = even_pieces(two[2], two[3]) + odd_pieces(two[2], two[3]);
    return even_pieces(first, second) + odd_pieces(first, second);
}

/// Sums of any number of packs, one after the other; those of a group of eight cost hardly more than one.
template<std::size_t N> [[gnu::always_inline]] inline std::array<double, N> sum_lanes_of(const std::array<Pack, N>& a)
{
    std::array<double, N> sums;
    unrolled<(N + 7) / 8>([&](auto part) __attribute__((always_inline)) {
        constexpr std::size_t begin = 8 * part, count = N - begin < 8 ? N - begin : 8;
        std::array<Pack, 8> group{};
        unrolled<count>([&](auto k) __attribute__((always_inline)) { group[k] = a[begin + k]; });
        const Pack eight = sum_lanes(group);
        unrolled<count>([&](auto k) __attribute__((always_inline)) { sums[begin + k] = eight[k.value]; });
    });
    return sums;
}

/// Dot product of two short vectors of numbers, summed from the first component on.
template<class T, std::size_t D> T dot(const std::array<T, D>& a, const std::array<T, D>& b)
{
    T sum = a[0] * b[0];
    for (std::size_t k = 1; k < D; ++k) sum = multiply_add(a[k], b[k], sum);
    return sum;
}

} // namespace sph

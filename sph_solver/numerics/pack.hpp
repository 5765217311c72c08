// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#if defined(__AVX__)
#include <immintrin.h>
#endif

/// \file
/// Four doubles computed side by side, and the few functions that the pair formulas need of a number type.
/// Every formula of a pair is a template on its number type: `double` is the readable reference that the tests use,
/// `Pack` is what the particle loops run. Both give the same bits: the compiler may not fuse a product and a sum on
/// its own (the project compiles with -ffp-contract=off). Where `multiply_add` fuses them, changing the sign of one
/// factor and of the summand changes the sign of the result and nothing else, which is what opposite fluxes of a pair
/// need; a sum of two products that belong to the two sides of a pair must not be fused.
namespace sph {

inline constexpr int pack_size = 4;

/// Four doubles. Arithmetic and comparisons work lane by lane (a vector type of GCC and Clang).
using Pack = double __attribute__((vector_size(pack_size * sizeof(double))));

/// Two-way names for one operation, so that a formula reads the same for `double` and for `Pack`.
inline double maximum(double a, double b) { return a > b ? a : b; }
inline double square_root(double a) { return std::sqrt(a); }
inline double select_positive(double sign, double if_positive, double otherwise)
{
    return sign > 0.0 ? if_positive : otherwise;
}

inline Pack maximum(Pack a, Pack b)
{
#if defined(__AVX__)
    return _mm256_max_pd(a, b);
#else
    return a > b ? a : b;
#endif
}
inline Pack maximum(Pack a, double b) { return maximum(a, Pack{b, b, b, b}); }

inline Pack square_root(Pack a)
{
#if defined(__AVX__)
    return _mm256_sqrt_pd(a);
#else
    return Pack{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

/// Lane by lane: `if_positive` where sign > 0, else `otherwise`.
inline Pack select_positive(Pack sign, Pack if_positive, Pack otherwise)
{
    return sign > Pack{} ? if_positive : otherwise;
}

/// Sum over the lanes, always in the same tree: (0 + 1) + (2 + 3).
inline double sum_lanes(Pack a) { return (a[0] + a[1]) + (a[2] + a[3]); }

/// a b + c, rounded once where the processor can.
inline double multiply_add(double a, double b, double c)
{
#if defined(__FMA__)
    return __builtin_fma(a, b, c);
#else
    return a * b + c;
#endif
}

inline Pack multiply_add(Pack a, Pack b, Pack c)
{
#if defined(__FMA__)
    return _mm256_fmadd_pd(a, b, c);
#else
    return a * b + c;
#endif
}

inline Pack load_pack(const double* from)
{
    Pack pack;
    std::memcpy(&pack, from, sizeof(pack));
    return pack;
}

/// Turns four rows of four numbers into four columns: out[c] holds component c of the rows 0..3.
inline std::array<Pack, 4> transpose(Pack row0, Pack row1, Pack row2, Pack row3)
{
    const Pack low01 = __builtin_shufflevector(row0, row1, 0, 4, 2, 6);
    const Pack high01 = __builtin_shufflevector(row0, row1, 1, 5, 3, 7);
    const Pack low23 = __builtin_shufflevector(row2, row3, 0, 4, 2, 6);
    const Pack high23 = __builtin_shufflevector(row2, row3, 1, 5, 3, 7);
    return {__builtin_shufflevector(low01, low23, 0, 1, 4, 5), __builtin_shufflevector(high01, high23, 0, 1, 4, 5),
            __builtin_shufflevector(low01, low23, 2, 3, 6, 7), __builtin_shufflevector(high01, high23, 2, 3, 6, 7)};
}

/// Dot product of two short vectors of numbers, summed from the first component on.
template<class T, std::size_t D> T dot(const std::array<T, D>& a, const std::array<T, D>& b)
{
    T sum = a[0] * b[0];
    for (std::size_t k = 1; k < D; ++k) sum = multiply_add(a[k], b[k], sum);
    return sum;
}

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#if defined(__AVX__)
#include <immintrin.h>
#endif

/// \file
/// Doubles computed side by side, and the few functions that the pair formulas need of a number type.
/// Every formula of a pair is a template on its number type: `double` is the readable reference that the tests use,
/// `Pack` is what the particle loops run. Both give the same bits, on AVX2 and on AVX-512 machines: the compiler may
/// not fuse a product and a sum on its own (the project compiles with -ffp-contract=off). Where `multiply_add` fuses
/// them, changing the sign of one factor and of the summand changes the sign of the result and nothing else, which is
/// what opposite fluxes of a pair need; a sum of two products that belong to the two sides of a pair must not be fused.
namespace sph {

/// Rows of neighbours are filled up to multiples of this: one Pack where a register holds eight doubles, else two, the
/// two parts of the unit. Each part has sums of its own (for_each_part), so that every sum has the same order wherever
/// registers end.
inline constexpr int row_unit = 8;
/// The next multiple of row_unit.
constexpr std::size_t whole_units(std::size_t count) { return (count + row_unit - 1) / row_unit * row_unit; }

#if defined(__AVX512F__)
inline constexpr std::size_t pack_lanes = 8;
#else
inline constexpr std::size_t pack_lanes = 4;
#endif
inline constexpr std::size_t pack_parts = row_unit / pack_lanes;

/// As many doubles as a register holds (a vector type of GCC and Clang). Arithmetic works lane by lane. It must not be
/// wrapped in a struct of registers: GCC 12 copies those through memory, in pieces that the next load then waits for.
using Pack = double __attribute__((vector_size(pack_lanes * sizeof(double))));

/// The same number in each lane.
inline Pack everywhere(double a) { return a - Pack{}; }
inline Pack everywhere(Pack a) { return a; }

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

/// c - a b, rounded once where the processor can.
inline double subtract_product(double c, double a, double b) { return multiply_add(-a, b, c); }

#if defined(__AVX512F__)
inline Pack maximum(Pack a, Pack b) // the masked form: GCC 12 warns of the plain one
{
    return _mm512_mask_max_pd(a, 0xff, a, b);
}
inline Pack square_root(Pack a) { return _mm512_mask_sqrt_pd(a, 0xff, a); }
inline Pack multiply_add(Pack a, Pack b, Pack c) { return _mm512_fmadd_pd(a, b, c); }
inline Pack subtract_product(Pack c, Pack a, Pack b) { return _mm512_fnmadd_pd(a, b, c); }
#else
inline Pack maximum(Pack a, Pack b)
{
#if defined(__AVX__)
    return _mm256_max_pd(a, b);
#else
    return a > b ? a : b;
#endif
}
inline Pack square_root(Pack a)
{
#if defined(__AVX__)
    return _mm256_sqrt_pd(a);
#else
    for (std::size_t k = 0; k < pack_lanes; ++k) a[k] = std::sqrt(a[k]);
    return a;
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
inline Pack subtract_product(Pack c, Pack a, Pack b)
{
#if defined(__FMA__)
    return _mm256_fnmadd_pd(a, b, c);
#else
    return c - a * b;
#endif
}
#endif
/// A choice of lanes: the first `count` of them.
#if defined(__AVX512F__)
using Lanes = __mmask8;
inline Lanes first_lanes(std::size_t count) { return static_cast<Lanes>((1u << count) - 1u); }
inline Pack choose(Lanes which, Pack chosen, Pack other) { return _mm512_mask_mov_pd(other, which, chosen); }
#else
using Lanes = std::int64_t __attribute__((vector_size(sizeof(Pack))));
inline Lanes first_lanes(std::size_t count) { return Lanes{0, 1, 2, 3} < static_cast<std::int64_t>(count) - Lanes{}; }
inline Pack choose(Lanes which, Pack chosen, Pack other) { return which ? chosen : other; }
#endif

/// Lane by lane: `if_positive` where sign > 0, else `otherwise`.
inline Pack select_positive(Pack sign, Pack if_positive, Pack otherwise)
{
    return sign > Pack{} ? if_positive : otherwise;
}
inline Pack maximum(Pack a, double b) { return maximum(a, everywhere(b)); }

inline Pack load_pack(const double* from)
{
    Pack pack;
    std::memcpy(&pack, from, sizeof(pack));
    return pack;
}

inline void store_pack(double* to, Pack pack) { std::memcpy(to, &pack, sizeof(pack)); }

inline void add_pack(double* to, Pack pack) { store_pack(to, load_pack(to) + pack); }

/// Calls visit(part, n) for the packs of a row of `count` entries: n is a pack's first entry, ascending, and `part`, a
/// constant, tells which part of a unit it is.
template<class Visit> [[gnu::always_inline]] inline void for_each_part(std::size_t count, Visit visit)
{
    std::size_t n = 0;
    for (; n + row_unit <= count; n += row_unit)
        unrolled<pack_parts>([&](auto part) __attribute__((always_inline)) { visit(part, n + part * pack_lanes); });
    if (n < count) visit(std::integral_constant<std::size_t, 0>{}, n);
}

/// Dot product of two short vectors of numbers, summed from the first component on.
template<class T, std::size_t D> T dot(const std::array<T, D>& a, const std::array<T, D>& b)
{
    T sum = a[0] * b[0];
    for (std::size_t k = 1; k < D; ++k) sum = multiply_add(a[k], b[k], sum);
    return sum;
}

} // namespace sph

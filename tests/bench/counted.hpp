// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/kernel.hpp"
#include "sph_solver/numerics/muscl.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cmath>

namespace sph {

/// A number that counts what is done with it: a sum, product, maximum, division or root is one flop, a fused product and sum
/// two; signs and choices are none, and nor is what constants do among themselves. The pair formulas are templates on their
/// number type, so they count themselves.
struct Counted {
    double value = 0;
    bool constant = true;
    inline static long flops = 0;

    Counted() = default;
    Counted(double v) : value(v) {}

    static Counted variable(double v) { return made(v, false); }
    static Counted made(double v, bool constant)
    {
        Counted result(v);
        result.constant = constant;
        return result;
    }
};

inline Counted operation(double value, Counted a, Counted b)
{
    const bool constant = a.constant && b.constant;
    if (!constant) ++Counted::flops;
    return Counted::made(value, constant);
}
inline Counted operator+(Counted a, Counted b) { return operation(a.value + b.value, a, b); }
inline Counted operator-(Counted a, Counted b) { return operation(a.value - b.value, a, b); }
inline Counted operator*(Counted a, Counted b) { return operation(a.value * b.value, a, b); }
inline Counted operator/(Counted a, Counted b) { return operation(a.value / b.value, a, b); }
inline Counted operator-(Counted a) { return Counted::made(-a.value, a.constant); }
inline Counted maximum(Counted a, Counted b) { return operation(a.value > b.value ? a.value : b.value, a, b); }
inline Counted multiply_add(Counted a, Counted b, Counted c) { return a * b + c; }
inline Counted subtract_product(Counted c, Counted a, Counted b) { return c - a * b; }
inline Counted square_root(Counted a) { return operation(std::sqrt(a.value), a, a); }
inline Counted select_positive(Counted sign, Counted if_positive, Counted otherwise)
{
    return sign.value > 0 ? if_positive : otherwise;
}

/// Flops of both passes for one directed pair: pass 1 sees each pair from both sides, pass 2 solves a face once.
template<int D> double flops_of_a_directed_pair(const CubicSpline<D>& kernel, const Tait& eos)
{
    const auto number = [] { return Counted::variable(0.5 + 1e-3 * static_cast<double>(Counted::flops % 7)); };
    const auto vector = [&] {
        std::array<Counted, D> numbers;
        for (Counted& each : numbers) each = number();
        return numbers;
    };
    const auto distance = [&](const std::array<Counted, D>& x) { return square_root(dot(x, x) + 1e-300); };

    Counted::flops = 2 * D + 1; // differences of x, v and q
    const auto x = vector();
    const Counted r = distance(x);
    Counted weight = number() * (kernel.slope(r) / r);
    for (const Counted& each : x) (void)(weight * each);
    Counted::flops += 2 * (D * (D + 1) / 2 + D * D + D); // sums of M, G[v] and G[q]
    const double gradients = static_cast<double>(Counted::flops);

    Counted::flops = 4 * D;                      // differences of x and v, the mean velocity
    Counted::flops += 2 * (D + 1) * (2 * D - 1); // what the gradients of both sides predict
    PairView<D, Counted> pair;
    pair.x = vector();
    pair.velocity_jump = vector();
    pair.velocity_slope_i = vector();
    pair.velocity_slope_j = vector();
    const Counted length = distance(pair.x);
    pair.inverse_distance = 1.0 / length;
    const Counted strength = (number() * number()) * (2.0 * kernel.slope(length));
    const RatioView<Counted> ratio{number(), number(), number(), number()};
    const auto star = ExactRiemann{}(reconstruct_face(pair, ratio, 1.0 / eos.c0, VanAlbada{}));
    Counted::flops += D * (D + 1) / 2 + D + D * (2 * D - 1) + D + 2 * D; // renormalised areas: direction and opening
    const Counted u = eos.c0 * star.u, per_length = strength * pair.inverse_distance;
    (void)(eos.pressure_at_ratio(star.q) * per_length);
    (void)(per_length * number());
    (void)(strength * (eos.rho0 * star.q * u));
    (void)face_velocity(face_frame<D>(pair, vector()), u, VanAlbada{});
    Counted::flops += 2 * D;           // pressure and mass flux along the axes
    Counted::flops += 2 * (2 * D + 2); // sums on both sides
    return gradients + 0.5 * static_cast<double>(Counted::flops);
}

/// Sixteen chains of fused products and sums.
inline Pack busy_chains(std::size_t turns)
{
    constexpr std::size_t chains = 16;
    std::array<Pack, chains> a;
    for (std::size_t k = 0; k < chains; ++k) a[k] = everywhere(static_cast<double>(k));
    const Pack factor = everywhere(0.999), summand = everywhere(1e-3);
    for (std::size_t n = 0; n < turns; ++n)
        unrolled<chains>([&](auto k) __attribute__((always_inline)) { a[k] = multiply_add(a[k], factor, summand); });
    Pack sum{};
    for (const Pack& each : a) sum += each;
    return sum;
}

/// Flops of fused products and sums that this core does in a second where nothing else holds it up.
inline double peak_flops()
{
    constexpr std::size_t turns = 200000;
    double least = 1e300;
    for (int repetition = 0; repetition < 50; ++repetition) {
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(busy_chains(turns));
        least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return 2.0 * pack_lanes * 16 * turns / least;
}

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/foundation/check.hpp"

#include <cmath>
#include <cstdint>

namespace base {

/// A sum of doubles that depends neither on the order of its terms nor on how they are spread over ranks.
///
/// Every term is rounded to a multiple of the quantum 2^-80 (8e-25) and added as a 128-bit integer; integer addition
/// is associative. |sum| stays below 2^46 (7e13), far above any force, energy or mass in SI units that Rivage meets.
/// Trivially copyable, 16 bytes: it travels in messages as it is.
class ReproducibleSum {
public:
    /// Adds one term. Throws Error(numerical_failure) when it is NaN or not below 2^45 in magnitude.
    void add(double term)
    {
        require(std::abs(term) < limit_, ExitCode::numerical_failure, "a term of a sum is ", term,
                ", which is not a number or beyond 3.5e13: the computation has diverged");
        units_ += static_cast<__int128>(term * per_unit_);
    }

    ReproducibleSum& operator+=(const ReproducibleSum& other)
    {
        units_ += other.units_;
        return *this;
    }

    /// The sum as a double; depends on nothing but the sum, and is exact where a double can hold it.
    double value() const
    {
        const bool negative = units_ < 0;
        const auto magnitude = static_cast<unsigned __int128>(negative ? -units_ : units_);
        const double high = static_cast<double>(static_cast<std::int64_t>(magnitude >> 64)) * 0x1p-16;
        const double low = static_cast<double>(static_cast<std::uint64_t>(magnitude)) * 0x1p-80;
        return negative ? -(high + low) : high + low;
    }

    /// |value()| in whole multiples of 2^-16, rounded down; cheaper, for guards.
    std::int64_t coarse_magnitude() const
    {
        const auto high = static_cast<std::int64_t>(units_ >> 64);
        return high < 0 ? ~high : high;
    }

    friend bool operator==(const ReproducibleSum&, const ReproducibleSum&) = default;

private:
    static constexpr double per_unit_ = 1208925819614629174706176.0; // 2^80
    static constexpr double limit_ = 35184372088832.0;               // 2^45
    __int128 units_ = 0;
};

} // namespace base

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace sph::sample {

/// A repeatable stream of numbers in [-1, 1), the same on every machine.
class Noise {
public:
    explicit Noise(std::uint64_t seed) : state_(seed) {}

    double operator()()
    {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) * (2.0 / 9007199254740992.0) - 1.0;
    }

private:
    std::uint64_t state_;
};

} // namespace sph::sample

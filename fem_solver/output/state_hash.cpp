// SPDX-License-Identifier: MIT
#include "fem_solver/output/state_hash.hpp"

#include <bit>
#include <cstdint>
#include <cstdio>

namespace fem {
namespace {

/// FNV-1a over the bytes of each number.
std::uint64_t add(std::uint64_t hash, const Eigen::VectorXd& field)
{
    for (const double value : field) {
        std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
        for (int byte = 0; byte < 8; ++byte, bits >>= 8) hash = (hash ^ (bits & 0xff)) * 0x100000001b3ULL;
    }
    return hash;
}

} // namespace

std::string state_hash(const Motion& motion)
{
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const auto field : {&Motion::displacement, &Motion::velocity, &Motion::acceleration})
        hash = add(hash, motion.*field);
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    return digits;
}

} // namespace fem

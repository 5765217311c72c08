// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/checksum.hpp"

#include <cstring>

namespace coupler {
namespace {

constexpr std::uint64_t factor_a = 0x9E3779B97F4A7C15u; // 2^64 / golden ratio, odd
constexpr std::uint64_t factor_b = 0xD6E8FEB86659FD93u;

std::uint64_t word_at(const unsigned char* bytes)
{
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, sizeof(word));
    return word;
}

/// Both halves of the 128-bit product of two words: every bit of either reaches every bit of the lane.
std::uint64_t mixed(std::uint64_t lane, std::uint64_t first, std::uint64_t second)
{
    const auto product = static_cast<unsigned __int128>(first ^ factor_a) * (second ^ lane);
    return lane + (static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64));
}

std::uint64_t finished(std::uint64_t value)
{
    value = (value ^ (value >> 32)) * factor_b;
    value = (value ^ (value >> 32)) * factor_b;
    return value ^ (value >> 32);
}

} // namespace

std::uint64_t checksum(const void* data, std::size_t bytes)
{
    const auto* at = static_cast<const unsigned char*>(data);
    std::uint64_t lanes[4] = {bytes + factor_b, ~bytes, bytes + factor_a, bytes ^ factor_b};
    std::size_t left = bytes;
    for (; left >= 64; left -= 64, at += 64)
        for (int lane = 0; lane < 4; ++lane)
            lanes[lane] = mixed(lanes[lane], word_at(at + 16 * lane), word_at(at + 16 * lane + 8));
    for (; left >= 8; left -= 8, at += 8) lanes[0] = mixed(lanes[0], word_at(at), left);
    std::uint64_t rest = 0;
    std::memcpy(&rest, at, left);
    lanes[1] = mixed(lanes[1], rest, factor_b);
    std::uint64_t sum = 0;
    for (const std::uint64_t lane : lanes) sum = finished(sum ^ lane);
    return sum;
}

} // namespace coupler

// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

namespace coupler {

/// 64-bit checksum of `bytes` bytes, four independent lanes of 64 x 64 to 128 bit products over 8-byte words (some
/// bytes a clock cycle). It guards against mixed-up and damaged packets, not against intent. The length counts.
std::uint64_t checksum(const void* data, std::size_t bytes);

} // namespace coupler

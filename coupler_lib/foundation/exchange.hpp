// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/foundation/communicator.hpp"

#include <cstring>
#include <vector>

namespace base {

/// Everybody sends bytes to whom it likes: buffers[r] goes to rank r, entry r of the answer came from rank r.
/// Nobody needs to know beforehand who sends to it. Collective; empty buffers cost no message.
std::vector<std::vector<char>> exchange_bytes(const Communicator& comm, const std::vector<std::vector<char>>& buffers);

/// Appends the bytes of one trivially copyable item.
template<class T> void append_bytes(std::vector<char>& buffer, const T& item)
{
    const auto* bytes = reinterpret_cast<const char*>(&item);
    buffer.insert(buffer.end(), bytes, bytes + sizeof(T));
}

/// Reads one item and steps over it.
template<class T> void read_bytes(const char*& bytes, T& item)
{
    std::memcpy(static_cast<void*>(&item), bytes, sizeof(T));
    bytes += sizeof(T);
}

} // namespace base

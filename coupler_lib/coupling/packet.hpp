// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/surface.hpp"

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace coupler {

enum class Field : std::int32_t { load = 1, motion = 2 };

/// What a packet holds besides its header, and what its sender wishes.
enum PacketFlag : std::uint32_t {
    window_is_last = 1,       ///< Window::last
    window_stops = 2,         ///< Window::stop_requested: agreed on
    sender_asked_to_stop = 4, ///< the sender knows of a request to stop (solid: also of any fluid rank's)
    with_topology = 8,        ///< motion: ids and connectivity travel too
    with_force = 16,          ///< load: conservative nodal forces
    with_pressure = 32,       ///< load: averaged sums
    force_is_whole = 64       ///< load: doubles, from the only rank of the fluid; otherwise exact sums to be added up
};

/// Leads every packet; what follows it is `bytes` long.
struct PacketHeader {
    std::uint32_t magic = 0;
    Field field = Field::load;
    std::int64_t sequence = 0; ///< counts the packets from this sender to this receiver
    std::int64_t step = 0;
    double time = 0; ///< [s]
    double dt = 0;   ///< [s]
    std::int32_t dimension = 0;
    std::uint32_t flags = 0; ///< PacketFlag
    std::int64_t facets = 0; ///< count that this packet is about
    std::int64_t nodes = 0;  ///< count that this packet is about
    std::int64_t bytes = 0;  ///< behind the header
    std::uint64_t check = 0; ///< checksum over the header with check = 0, and the body

    bool has(PacketFlag flag) const { return (flags & flag) != 0; }
};

/// "load 17 (packet 18, t = 0.001 s, dt = 1e-05 s, 2D)"
std::string describe(const PacketHeader& header);

/// A packet being written: a header, then items and arrays one after the other. The buffer is kept from step to step.
class PacketWriter {
public:
    /// Forgets what it held; leaves room for the header.
    void begin() { grow(0, sizeof(PacketHeader)); }
    template<class T> void put(const T& item) { put(&item, 1); }
    template<class T> void put(const std::vector<T>& items) { put(items.data(), items.size()); }
    template<class T> void put(const T* items, std::size_t count)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        if (count > 0) std::memcpy(room(count * sizeof(T)), static_cast<const void*>(items), count * sizeof(T));
    }
    /// Appends so many bytes, to be filled in by the caller before the next call.
    char* room(std::size_t bytes)
    {
        const std::size_t at = used_;
        grow(at, bytes);
        return buffer_.data() + at;
    }
    /// Puts the header in front, with magic, length and checksum filled in.
    void finish(PacketHeader header);

    std::span<const char> bytes() const { return {buffer_.data(), used_}; }

private:
    void grow(std::size_t at, std::size_t bytes)
    {
        used_ = at + bytes;
        if (used_ > buffer_.size()) buffer_.resize(2 * used_);
    }
    std::vector<char> buffer_; ///< never shrinks
    std::size_t used_ = 0;
};

/// A packet that has arrived. The constructor checks magic, length and checksum and throws base::Error(bad_input) with
/// the reason; `take` throws when more is asked for than there is.
class PacketReader {
public:
    /// \param buffer  must outlive the reader
    explicit PacketReader(const std::vector<char>& buffer);

    const PacketHeader& header() const { return header_; }

    template<class T> void take(T& item) { take(&item, 1); }
    template<class T> void take(std::vector<T>& items, std::size_t count)
    {
        need(count, sizeof(T));
        items.resize(count);
        take(items.data(), count);
    }
    template<class T> void take(T* items, std::size_t count)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        const char* from = view(count, sizeof(T));
        if (count > 0) std::memcpy(static_cast<void*>(items), from, count * sizeof(T));
    }
    /// The next items where they lie; valid as long as the buffer.
    const char* view(std::size_t count, std::size_t bytes_each)
    {
        need(count, bytes_each);
        at_ += count * bytes_each;
        return buffer_.data() + at_ - count * bytes_each;
    }
    /// Throws when bytes are left over.
    void finish() const;

private:
    void need(std::size_t count, std::size_t bytes_each) const;
    [[noreturn]] void refuse(const std::string& why) const;

    const std::vector<char>& buffer_;
    PacketHeader header_;
    std::size_t at_ = sizeof(PacketHeader);
};

} // namespace coupler

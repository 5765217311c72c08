// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/recorder/traffic_info.hpp"

#include <cstdint>
#include <hdf5.h>
#include <span>
#include <vector>

namespace coupler {

enum class Direction { sent, received };

/// All packets that one rank sent and received, in an HDF5 file. The layout, for each peer k = 0, 1, ...:
///
///     /            attributes format, role, rank, ranks, partner, partner_ranks, config_hash, git_hash
///     /sent/k/bytes, /received/k/bytes    the packets one after the other, as they travelled
///     /sent/k/end, /received/k/end        where each of them ends [byte]
///
/// The file is written in HDF5's single-writer mode and stays readable up to the last flush when the program is killed.
class TrafficWriter {
public:
    /// \throws base::Error bad_input with the path when the file cannot be made.
    TrafficWriter(const std::string& path, const TrafficInfo& info);
    ~TrafficWriter();
    TrafficWriter(const TrafficWriter&) = delete;
    TrafficWriter& operator=(const TrafficWriter&) = delete;

    /// Keeps a packet; it is on file after the next flush, which comes by itself once a second or megabyte.
    void put(Direction direction, std::size_t peer, std::span<const char> packet);
    /// \throws base::Error bad_input when the disk is full.
    void flush();

private:
    struct Stream;
    std::string path_;
    hid_t file_ = -1;
    std::vector<Stream> streams_; ///< sent 0, received 0, sent 1, ...
    std::size_t waiting_ = 0;     ///< bytes not on file yet
    double flushed_ = 0;          ///< when [s]
};

/// Reads such a file, packet after packet.
class TrafficReader {
public:
    /// \throws base::Error bad_input with the path for what is no such file.
    explicit TrafficReader(const std::string& path);
    ~TrafficReader();
    TrafficReader(const TrafficReader&) = delete;
    TrafficReader& operator=(const TrafficReader&) = delete;

    const TrafficInfo& info() const { return info_; }
    /// The next packet of a stream. \return false at its end
    bool next(Direction direction, std::size_t peer, std::vector<char>& packet);

private:
    struct Stream {
        hid_t bytes = -1;
        std::vector<std::int64_t> ends;
        std::size_t at = 0;
    };
    void open_stream(Direction direction, int peer);

    std::string path_;
    hid_t file_ = -1;
    TrafficInfo info_;
    std::vector<Stream> streams_; ///< sent 0, received 0, sent 1, ...
};

} // namespace coupler

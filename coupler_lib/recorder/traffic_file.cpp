// SPDX-License-Identifier: MIT
#include "coupler_lib/recorder/traffic_file.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <mpi.h>

namespace coupler {
namespace {

constexpr const char* format = "rivage traffic 1";
constexpr hsize_t bytes_per_chunk = 1 << 16, ends_per_chunk = 1 << 10;
constexpr std::size_t flush_bytes = 1 << 20;
constexpr double flush_seconds = 1;

std::size_t stream_of(Direction direction, std::size_t peer)
{
    return 2 * peer + (direction == Direction::sent ? 0 : 1);
}

std::string group_of(Direction direction, std::size_t peer)
{
    return (direction == Direction::sent ? "/sent/" : "/received/") + std::to_string(peer);
}

void put_attribute(hid_t file, const char* name, const std::string& value)
{
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, value.size() + 1);
    const hid_t attribute = H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, value.c_str());
    H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(type);
}

std::string get_attribute(hid_t file, const char* name)
{
    if (H5Aexists(file, name) <= 0) return "";
    const hid_t attribute = H5Aopen(file, name, H5P_DEFAULT), type = H5Aget_type(attribute);
    std::string value(H5Tget_size(type), '\0');
    H5Aread(attribute, type, value.data());
    H5Tclose(type);
    H5Aclose(attribute);
    return value.substr(0, value.find('\0'));
}

/// An empty dataset that grows.
hid_t make_series(hid_t group, const char* name, hid_t type, hsize_t chunk)
{
    const hsize_t none = 0, unlimited = H5S_UNLIMITED;
    const hid_t space = H5Screate_simple(1, &none, &unlimited), layout = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(layout, 1, &chunk);
    const hid_t series = H5Dcreate2(group, name, type, space, H5P_DEFAULT, layout, H5P_DEFAULT);
    put_attribute(series, "unit", "byte");
    H5Pclose(layout);
    H5Sclose(space);
    return series;
}

/// Appends to a dataset. \return whether that went well
bool append(hid_t series, hid_t type, const void* items, hsize_t count)
{
    if (count == 0) return true;
    const hid_t old_space = H5Dget_space(series);
    hsize_t size = 0;
    H5Sget_simple_extent_dims(old_space, &size, nullptr);
    H5Sclose(old_space);
    const hsize_t grown = size + count;
    if (H5Dset_extent(series, &grown) < 0) return false;
    const hid_t space = H5Dget_space(series), memory = H5Screate_simple(1, &count, nullptr);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, &size, nullptr, &count, nullptr);
    const bool good = H5Dwrite(series, type, memory, space, H5P_DEFAULT, items) >= 0;
    H5Sclose(memory);
    H5Sclose(space);
    return good && H5Dflush(series) >= 0;
}

hsize_t size_of(hid_t series)
{
    const hid_t space = H5Dget_space(series);
    hsize_t size = 0;
    H5Sget_simple_extent_dims(space, &size, nullptr);
    H5Sclose(space);
    return size;
}

/// HDF5 prints what goes wrong; we say it ourselves.
struct Quiet {
    H5E_auto2_t print = nullptr;
    void* data = nullptr;
    Quiet()
    {
        H5Eget_auto2(H5E_DEFAULT, &print, &data);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~Quiet() { H5Eset_auto2(H5E_DEFAULT, print, data); }
};

} // namespace

std::string traffic_path(const std::string& path, const std::string& role, const std::string& partner, int rank)
{
    const std::size_t folder = path.find_last_of('/') + 1; // 0 without one
    const std::size_t dot = path.find('.', folder);
    const std::size_t end = dot == std::string::npos ? path.size() : dot;
    return path.substr(0, end) + "." + role + "." + partner + "." + std::to_string(rank) + path.substr(end);
}

struct TrafficWriter::Stream {
    hid_t bytes = -1, ends = -1;
    std::int64_t size = 0;
    std::vector<char> new_bytes;
    std::vector<std::int64_t> new_ends;
};

TrafficWriter::TrafficWriter(const std::string& path, const TrafficInfo& info) : path_(path), flushed_(MPI_Wtime())
{
    const Quiet quiet;
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
    file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
    base::require_input(file_ >= 0, "cannot make the recording '", path,
                        "'; does its folder exist, is it open elsewhere?");
    put_attribute(file_, "format", format);
    put_attribute(file_, "role", info.role);
    put_attribute(file_, "rank", std::to_string(info.rank));
    put_attribute(file_, "ranks", std::to_string(info.ranks));
    put_attribute(file_, "partner", info.partner);
    put_attribute(file_, "partner_ranks", std::to_string(info.partner_ranks));
    put_attribute(file_, "config_hash", info.config_hash);
    put_attribute(file_, "git_hash", info.git_hash);
    const hid_t parents = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(parents, 1);
    for (std::size_t peer = 0; peer < static_cast<std::size_t>(info.partner_ranks); ++peer)
        for (const Direction direction : {Direction::sent, Direction::received}) {
            const hid_t group = H5Gcreate2(file_, group_of(direction, peer).c_str(), parents, H5P_DEFAULT, H5P_DEFAULT);
            Stream& stream = streams_.emplace_back();
            stream.bytes = make_series(group, "bytes", H5T_NATIVE_UINT8, bytes_per_chunk);
            stream.ends = make_series(group, "end", H5T_NATIVE_INT64, ends_per_chunk);
            H5Gclose(group);
        }
    H5Pclose(parents);
    base::require_input(H5Fstart_swmr_write(file_) >= 0, "cannot write the recording '", path, "' so that it survives");
}

TrafficWriter::~TrafficWriter()
{
    try {
        flush();
    } catch (const base::Error&) {
        // The disk is full: what was flushed before is there.
    }
    for (const Stream& stream : streams_) {
        H5Dclose(stream.bytes);
        H5Dclose(stream.ends);
    }
    H5Fclose(file_);
}

void TrafficWriter::put(Direction direction, std::size_t peer, std::span<const char> packet)
{
    Stream& stream = streams_[stream_of(direction, peer)];
    stream.new_bytes.insert(stream.new_bytes.end(), packet.begin(), packet.end());
    stream.size += static_cast<std::int64_t>(packet.size());
    stream.new_ends.push_back(stream.size);
    waiting_ += packet.size();
    if (waiting_ > flush_bytes || MPI_Wtime() > flushed_ + flush_seconds) flush();
}

void TrafficWriter::flush()
{
    const Quiet quiet;
    bool good = true;
    for (Stream& stream : streams_) { // bytes first: an end on file is one of bytes on file
        good = append(stream.bytes, H5T_NATIVE_UINT8, stream.new_bytes.data(), stream.new_bytes.size()) && good;
        good = append(stream.ends, H5T_NATIVE_INT64, stream.new_ends.data(), stream.new_ends.size()) && good;
        stream.new_bytes.clear();
        stream.new_ends.clear();
    }
    waiting_ = 0;
    flushed_ = MPI_Wtime();
    base::require_input(good, "cannot write the recording '", path_, "'; is the disk full?");
}

TrafficReader::TrafficReader(const std::string& path) : path_(path)
{
    const Quiet quiet;
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, H5P_DEFAULT);
    if (file_ < 0) file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    base::require_input(file_ >= 0, "cannot read the recording '", path, "'");
    if (get_attribute(file_, "format") != format) {
        H5Fclose(file_);
        throw base::Error(base::ExitCode::bad_input, "'" + path + "' is no recording of a coupled run");
    }
    const auto number = [&](const char* name) { return std::stoi("0" + get_attribute(file_, name)); };
    info_ = {get_attribute(file_, "role"),    number("rank"),          number("ranks"),
             get_attribute(file_, "partner"), number("partner_ranks"), get_attribute(file_, "config_hash"),
             get_attribute(file_, "git_hash")};
    for (int peer = 0; peer < info_.partner_ranks; ++peer)
        for (const Direction direction : {Direction::sent, Direction::received}) open_stream(direction, peer);
}

void TrafficReader::open_stream(Direction direction, int peer)
{
    const std::string group = group_of(direction, static_cast<std::size_t>(peer));
    Stream& stream = streams_.emplace_back();
    const hid_t ends = H5Dopen2(file_, (group + "/end").c_str(), H5P_DEFAULT);
    stream.bytes = H5Dopen2(file_, (group + "/bytes").c_str(), H5P_DEFAULT);
    base::require_input(ends >= 0 && stream.bytes >= 0, "the recording '", path_, "' lacks ", group);
    stream.ends.resize(size_of(ends));
    if (!stream.ends.empty()) H5Dread(ends, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, stream.ends.data());
    H5Dclose(ends);
    const auto there = static_cast<std::int64_t>(size_of(stream.bytes));
    while (!stream.ends.empty() && stream.ends.back() > there) stream.ends.pop_back(); // cut short between the two
}

TrafficReader::~TrafficReader()
{
    for (const Stream& stream : streams_) H5Dclose(stream.bytes);
    H5Fclose(file_);
}

bool TrafficReader::next(Direction direction, std::size_t peer, std::vector<char>& packet)
{
    Stream& stream = streams_[stream_of(direction, peer)];
    if (stream.at == stream.ends.size()) return false;
    const auto begin = static_cast<hsize_t>(stream.at == 0 ? 0 : stream.ends[stream.at - 1]);
    const hsize_t count = static_cast<hsize_t>(stream.ends[stream.at++]) - begin;
    packet.resize(count);
    const hid_t space = H5Dget_space(stream.bytes), memory = H5Screate_simple(1, &count, nullptr);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, &begin, nullptr, &count, nullptr);
    const bool good = H5Dread(stream.bytes, H5T_NATIVE_UINT8, memory, space, H5P_DEFAULT, packet.data()) >= 0;
    H5Sclose(memory);
    H5Sclose(space);
    base::require_input(good, "cannot read packet ", stream.at - 1, " of the recording '", path_, "'");
    return true;
}

} // namespace coupler

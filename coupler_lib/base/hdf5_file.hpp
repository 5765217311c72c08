// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/foundation/communicator.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace base {

/// One HDF5 file written by all ranks together. Every function is collective; the file is flushed after each write.
/// Throws Error(bad_input) when the file cannot be made, with its path.
class Hdf5File {
public:
    /// Makes the file, replacing an older one.
    static Hdf5File create(const std::string& path, const Communicator& comm);
    Hdf5File(Hdf5File&& other) noexcept;
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;
    Hdf5File& operator=(Hdf5File&&) = delete;
    ~Hdf5File();

    void create_group(const std::string& path);
    /// A dataset of shape (rows of all ranks, columns), the ranks' rows one after the other.
    void write_rows(const std::string& path, const double* rows, std::size_t local_rows, int columns);
    void write_rows(const std::string& path, const std::int64_t* rows, std::size_t local_rows, int columns);
    void write_rows(const std::string& path, const std::int32_t* rows, std::size_t local_rows, int columns);
    void attribute(const std::string& object, const std::string& name, const std::string& value);
    void attribute(const std::string& object, const std::string& name, double value);
    void flush();

private:
    Hdf5File(std::int64_t handle, const Communicator& comm, std::string path);
    void write_typed(const std::string& path, const void* rows, std::size_t local_rows, int columns, std::int64_t type);

    std::int64_t handle_;
    Communicator comm_;
    std::string path_;
};

}  // namespace base

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace base {

/// A dataset of numbers, row after row.
struct Hdf5Rows {
    std::vector<double> values;
    std::size_t rows = 0, columns = 1;

    [[nodiscard]] double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// An HDF5 file that this rank reads by itself. Throws Error(bad_input), with the path, for what cannot be read.
class Hdf5Reader {
public:
    explicit Hdf5Reader(const std::string& path);
    Hdf5Reader(const Hdf5Reader&) = delete;
    Hdf5Reader& operator=(const Hdf5Reader&) = delete;
    ~Hdf5Reader();

    [[nodiscard]] bool has(const std::string& dataset) const;
    /// All of a dataset of one or two dimensions, of any kind of number.
    [[nodiscard]] Hdf5Rows rows(const std::string& dataset) const;

private:
    std::string path_;
    std::int64_t handle_;
};

} // namespace base

// SPDX-License-Identifier: MIT
#include "coupler_lib/base/hdf5_reader.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <hdf5.h>

namespace base {
namespace {

/// Looks up each part of a path, since HDF5 wants every group on the way to exist.
bool exists(hid_t file, const std::string& path)
{
    for (std::size_t end = path.find('/', 1); end != std::string::npos; end = path.find('/', end + 1))
        if (H5Lexists(file, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    return H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
}

} // namespace

Hdf5Reader::Hdf5Reader(const std::string& path) : path_(path)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // errors are reported by us, with the path
    handle_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    require_input(handle_ >= 0, "cannot read '", path, "' as an HDF5 file; is the path right, was it cut short?");
}

Hdf5Reader::~Hdf5Reader() { H5Fclose(handle_); }

bool Hdf5Reader::has(const std::string& dataset) const { return exists(handle_, dataset); }

Hdf5Rows Hdf5Reader::rows(const std::string& dataset) const
{
    require_input(has(dataset), "the HDF5 file '", path_, "' has no dataset '", dataset, "'");
    const hid_t data = H5Dopen2(handle_, dataset.c_str(), H5P_DEFAULT);
    require_input(data >= 0, "'", dataset, "' in the HDF5 file '", path_, "' is not a dataset");
    const hid_t space = H5Dget_space(data);
    const int rank = H5Sget_simple_extent_ndims(space);
    hsize_t shape[2] = {0, 1};
    if (rank == 1 || rank == 2) H5Sget_simple_extent_dims(space, shape, nullptr);
    Hdf5Rows result{{}, shape[0], shape[1]};
    result.values.resize(result.rows * result.columns);
    const bool fine = (rank == 1 || rank == 2) &&
                      H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.values.data()) >= 0;
    H5Sclose(space);
    H5Dclose(data);
    require_input(fine, "cannot read '", dataset, "' in the HDF5 file '", path_,
                  "' as rows of numbers (one or two dimensions)");
    return result;
}

} // namespace base

// SPDX-License-Identifier: MIT
#include "coupler_lib/base/hdf5_file.hpp"

#include <hdf5.h>

namespace base {
namespace {

/// Closes an HDF5 handle at the end of its scope.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close)
    {
        require(id_ >= 0, ExitCode::bad_input, "HDF5 cannot make or open ", what);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { close_(id_); }
    operator hid_t() const { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// Rows of this rank and of all ranks, and where this rank's begin.
struct RowSplit {
    hsize_t mine, begin, all;
};

RowSplit split_rows(std::size_t local_rows, const Communicator& comm)
{
    const auto counts = comm.gather_all(std::vector<std::int64_t>{static_cast<std::int64_t>(local_rows)});
    RowSplit split{local_rows, 0, 0};
    for (int rank = 0; rank < comm.size(); ++rank) {
        if (rank < comm.rank()) split.begin += static_cast<hsize_t>(counts[static_cast<std::size_t>(rank)]);
        split.all += static_cast<hsize_t>(counts[static_cast<std::size_t>(rank)]);
    }
    return split;
}

}  // namespace

Hdf5File::Hdf5File(std::int64_t handle, const Communicator& comm, std::string path)
    : handle_(handle), comm_(comm), path_(std::move(path))
{
}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : handle_(other.handle_), comm_(other.comm_), path_(std::move(other.path_))
{
    other.handle_ = -1;
}

Hdf5File::~Hdf5File()
{
    if (handle_ >= 0) H5Fclose(handle_);
}

Hdf5File Hdf5File::create(const std::string& path, const Communicator& comm)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are reported by us, with the path
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "an access list");
    if (comm.size() > 1) H5Pset_fapl_mpio(access, comm.handle(), MPI_INFO_NULL);
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
    require_input(file >= 0, "cannot write the file '", path, "'; does its folder exist, is the disk full, is it open elsewhere?");
    return Hdf5File(file, comm, path);
}

void Hdf5File::create_group(const std::string& path)
{
    const Handle group(H5Gcreate2(handle_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, path_ + ":" + path);
}

void Hdf5File::write_typed(const std::string& path, const void* rows, std::size_t local_rows, int columns, std::int64_t type)
{
    const RowSplit split = split_rows(local_rows, comm_);
    const auto width = static_cast<hsize_t>(columns);
    const hsize_t shape[2] = {split.all, width};
    const int rank = columns == 1 ? 1 : 2;
    const Handle space(H5Screate_simple(rank, shape, nullptr), H5Sclose, path);
    const Handle dataset(H5Dcreate2(handle_, path.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                         path_ + ":" + path);
    if (split.all == 0) return;
    const hsize_t begin[2] = {split.begin, 0};
    const hsize_t count[2] = {split.mine, width};
    const Handle memory(H5Screate_simple(rank, count, nullptr), H5Sclose, path);
    if (split.mine > 0) {
        H5Sselect_hyperslab(space, H5S_SELECT_SET, begin, nullptr, count, nullptr);
    } else {
        H5Sselect_none(space);
        H5Sselect_none(memory);
    }
    const Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "a transfer list");
    if (comm_.size() > 1) H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
    const herr_t status = H5Dwrite(dataset, type, memory, space, transfer, rows);
    require(status >= 0, ExitCode::numerical_failure, "cannot write to '", path_, "'; is the disk full?");
}

void Hdf5File::write_rows(const std::string& path, const double* rows, std::size_t local_rows, int columns)
{
    write_typed(path, rows, local_rows, columns, H5T_NATIVE_DOUBLE);
}

void Hdf5File::write_rows(const std::string& path, const std::int64_t* rows, std::size_t local_rows, int columns)
{
    write_typed(path, rows, local_rows, columns, H5T_NATIVE_INT64);
}

void Hdf5File::write_rows(const std::string& path, const std::int32_t* rows, std::size_t local_rows, int columns)
{
    write_typed(path, rows, local_rows, columns, H5T_NATIVE_INT32);
}

void Hdf5File::attribute(const std::string& object, const std::string& name, const std::string& value)
{
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, name);
    H5Tset_size(type, value.empty() ? 1 : value.size());
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
    const Handle owner(H5Oopen(handle_, object.c_str(), H5P_DEFAULT), H5Oclose, path_ + ":" + object);
    const Handle attribute(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
    H5Awrite(attribute, type, value.c_str());
}

void Hdf5File::attribute(const std::string& object, const std::string& name, double value)
{
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
    const Handle owner(H5Oopen(handle_, object.c_str(), H5P_DEFAULT), H5Oclose, path_ + ":" + object);
    const Handle attribute(H5Acreate2(owner, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
    H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
}

void Hdf5File::flush() { H5Fflush(handle_, H5F_SCOPE_GLOBAL); }

}  // namespace base

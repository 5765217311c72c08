// SPDX-License-Identifier: MIT
#include "coupler_lib/base/version.hpp"

#include <rivage_version.hpp>

#include <fmt/format.h>
#include <hdf5.h>
#include <mpi.h>
#include <spdlog/version.h>
#include <toml++/toml.h>

namespace base {

std::string version() { return RIVAGE_VERSION; }
std::string git_hash() { return RIVAGE_GIT_HASH; }

std::string version_details()
{
    char mpi[MPI_MAX_LIBRARY_VERSION_STRING];
    int length = 0;
    MPI_Get_library_version(mpi, &length);
    const std::string mpi_line = std::string(mpi, static_cast<std::size_t>(length));
    return fmt::format("rivage {} (commit {})\ncompiler {}, {}\n{}\nHDF5 {}, toml++ {}.{}.{}, fmt {}, spdlog {}.{}.{}\n",
                       version(), git_hash(), RIVAGE_COMPILER, RIVAGE_BUILD_TYPE, mpi_line.substr(0, mpi_line.find(',')),
                       H5_VERS_INFO, TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH, FMT_VERSION, SPDLOG_VER_MAJOR,
                       SPDLOG_VER_MINOR, SPDLOG_VER_PATCH);
}

}  // namespace base

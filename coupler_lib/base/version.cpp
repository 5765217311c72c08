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

std::string parallel_libraries()
{
    char text[MPI_MAX_LIBRARY_VERSION_STRING];
    int length = 0;
    MPI_Get_library_version(text, &length);
    const std::string mpi(text, static_cast<std::size_t>(length));
    return fmt::format("{}, HDF5 {}", mpi.substr(0, mpi.find(',')), H5_VERS_INFO);
}

std::string version_details()
{
    return fmt::format("rivage {} (commit {})\ncompiler {}, {}\n{}, toml++ {}.{}.{}, fmt {}, spdlog {}.{}.{}\n",
                       version(), git_hash(), RIVAGE_COMPILER, RIVAGE_BUILD_TYPE, parallel_libraries(), TOML_LIB_MAJOR,
                       TOML_LIB_MINOR, TOML_LIB_PATCH, FMT_VERSION, SPDLOG_VER_MAJOR, SPDLOG_VER_MINOR,
                       SPDLOG_VER_PATCH);
}

} // namespace base

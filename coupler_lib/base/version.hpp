// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace base {

/// "0.1.0"
std::string version();
/// Commit the program was built from.
std::string git_hash();
/// "Open MPI v4.1.4, HDF5 1.10.8"; may be called before MPI_Init.
std::string parallel_libraries();
/// Version, commit, compiler, build type and the libraries with their versions, a line each.
std::string version_details();

} // namespace base

// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace base {

/// "0.1.0"
std::string version();
/// Commit the program was built from.
std::string git_hash();
/// Version, commit, compiler, build type and the libraries with their versions, a line each.
std::string version_details();

}  // namespace base

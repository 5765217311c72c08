// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/triangle_mesh.hpp"

#include <string>

namespace base {

/// Reads the triangles of an STL file, binary or ASCII; the file's normals are not used, its order of corners is.
/// \param metres_per_unit what one unit of the file is worth [m]: STL has no unit, many programs write millimetres.
/// Throws Error(bad_input), with the file and the line or the size, for what is not STL.
TriangleMesh read_stl(const std::string& path, double metres_per_unit = 1.0);

} // namespace base

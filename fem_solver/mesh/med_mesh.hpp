// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/mesh/mesh.hpp"

#include <string>

namespace fem {

/// A mesh in a MED file.
struct MedSpec {
    std::string path;
    std::string mesh;  ///< its name in the file; empty: the only one
    int dimension = 2; ///< of the model; in 2D the file's nodes may have a third coordinate, all the same
    double scale = 1;  ///< length of the file's unit [m]
};

/// The mesh of a file: cells of the model's dimension, all of one type, are its elements; the cells one dimension lower
/// give the groups of faces, whose outward sides follow from the elements and not from the file; groups of cells, of
/// faces and of nodes all give groups of nodes. Nodes of no element are left out.
/// \throws base::Error bad_input naming file, cell and position: mixed types, cells turned inside out, faces that
/// belong to no element or lie between two, groups of nothing.
Mesh read_med_mesh(const MedSpec& spec);

} // namespace fem

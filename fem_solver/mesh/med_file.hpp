// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/element_type.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fem {

/// The cells of one kind in a MED file.
struct MedCells {
    std::string name;                ///< as the file's format calls them: TRIA3, SEG2, ...
    int dimension = 0;               ///< 0 points, 1 edges, 2 faces, 3 volumes
    int nodes = 0;                   ///< of one cell
    std::optional<ElementType> type; ///< where this solver has it
    std::vector<int> connectivity;   ///< nodes from 0, in the order of this solver's shapes
    std::vector<int> families;       ///< one for each cell

    int count() const { return static_cast<int>(connectivity.size()) / nodes; }
};

/// What a MED file says of one mesh, still in the file's own terms.
struct MedContent {
    std::string mesh;                               ///< its name
    int dimension = 0;                              ///< of space in the file
    std::vector<double> points;                     ///< nodes * dimension, lengths in the file's unit
    std::vector<int> node_families;                 ///< one for each node
    std::vector<MedCells> cells;                    ///< every kind that the mesh has
    std::map<int, std::vector<std::string>> groups; ///< groups that a family belongs to
};

/// Reads a mesh from a file of MED 3 or 4, the format of Salome and Code_Aster, which Gmsh writes too.
/// Only reads; every rank may do so at the same time.
/// \param mesh name of the mesh; empty: the only one.
/// \throws base::Error bad_input naming the file and what is wrong with it.
MedContent read_med(const std::string& path, const std::string& mesh);

} // namespace fem

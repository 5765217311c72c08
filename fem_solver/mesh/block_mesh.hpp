// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/mesh/mesh.hpp"

namespace fem {

/// A rectangle or box cut into equal cells.
struct BlockSpec {
    ElementType element = ElementType::quad8;
    std::vector<double> low, high; ///< opposite corners [m], one entry per dimension
    std::vector<int> cells;        ///< number of elements along each direction
};

/// Structured mesh of a block, with the groups left and right (x), bottom and top (y), in 3D also back (low z) and
/// front (high z), and all (every boundary face; every node). Nodes are numbered with x fastest.
///
///           top
///        o---o---o
///  left  |   |   |  right      y
///        o---o---o             |
///         bottom               +-- x
///
/// \throws base::Error bad_input for a wrong number of entries, low >= high, or cells < 1.
Mesh make_block(const BlockSpec& spec);

} // namespace fem

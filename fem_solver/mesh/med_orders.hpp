// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/element_type.hpp"

#include <med.h>

#include <array>
#include <optional>
#include <span>

namespace fem {

/// One kind of cell of the MED format and what it is here.
struct MedKind {
    med_geometry_type code;
    const char* name;
    int dimension, nodes;
    std::optional<ElementType> type;
    std::span<const int> order; ///< node a of our shape is node order[a] of the file's; empty: the same order
};

namespace med_order {

/// The format counts the corners of a solid's first face the other way round, clockwise seen from inside; then the
/// middles of the lower, the upper, and the upright edges, then of lower, four side and upper faces, then the centre.
inline constexpr std::array tet4{0, 2, 1, 3};
inline constexpr std::array tet10{0, 2, 1, 3, 6, 5, 4, 7, 9, 8};
inline constexpr std::array hexa8{0, 3, 2, 1, 4, 7, 6, 5};
inline constexpr std::array hexa20{0, 3, 2, 1, 4, 7, 6, 5, 11, 10, 9, 8, 16, 19, 18, 17, 15, 14, 13, 12};
inline constexpr std::array hexa27{0,  3,  2,  1,  4,  7,  6,  5,  11, 10, 9,  8,  16, 19,
                                   18, 17, 15, 14, 13, 12, 20, 25, 24, 23, 22, 21, 26};

} // namespace med_order

/// Every kind of cell that is looked for in a file; those without a type are known so that they can be named.
inline const std::array<MedKind, 17> med_kinds{{
    {MED_POINT1, "POINT1", 0, 1, {}, {}},
    {MED_SEG2, "SEG2", 1, 2, {}, {}},
    {MED_SEG3, "SEG3", 1, 3, {}, {}},
    {MED_TRIA3, "TRIA3", 2, 3, ElementType::tri3, {}},
    {MED_TRIA6, "TRIA6", 2, 6, ElementType::tri6, {}},
    {MED_TRIA7, "TRIA7", 2, 7, {}, {}},
    {MED_QUAD4, "QUAD4", 2, 4, ElementType::quad4, {}},
    {MED_QUAD8, "QUAD8", 2, 8, ElementType::quad8, {}},
    {MED_QUAD9, "QUAD9", 2, 9, ElementType::quad9, {}},
    {MED_TETRA4, "TETRA4", 3, 4, ElementType::tet4, med_order::tet4},
    {MED_TETRA10, "TETRA10", 3, 10, ElementType::tet10, med_order::tet10},
    {MED_PYRA5, "PYRA5", 3, 5, {}, {}},
    {MED_PENTA6, "PENTA6", 3, 6, {}, {}},
    {MED_PENTA15, "PENTA15", 3, 15, {}, {}},
    {MED_HEXA8, "HEXA8", 3, 8, ElementType::hexa8, med_order::hexa8},
    {MED_HEXA20, "HEXA20", 3, 20, ElementType::hexa20, med_order::hexa20},
    {MED_HEXA27, "HEXA27", 3, 27, ElementType::hexa27, med_order::hexa27},
}};

} // namespace fem

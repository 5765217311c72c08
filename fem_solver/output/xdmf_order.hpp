// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/element_type.hpp"

#include <array>
#include <cstddef>

namespace fem {

/// Where XDMF's node `a` of an element stands in ours. XDMF has VTK's order (vtkQuadraticHexahedron,
/// vtkTriQuadraticHexahedron): edges of the upper face before the upright ones, faces in the order left, right, front,
/// back (by y), lower, upper.
inline std::size_t own_place(ElementType type, std::size_t a)
{
    constexpr std::array<std::size_t, 6> faces{25, 23, 22, 24, 20, 21};
    if (type != ElementType::hexa20 && type != ElementType::hexa27) return a;
    if (a >= 20 && a < 26) return faces[a - 20];
    if (a < 12 || a == 26) return a;
    return a < 16 ? a + 4 : a - 4;
}

} // namespace fem

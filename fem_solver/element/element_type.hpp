// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/biquadratic.hpp"
#include "fem_solver/element/tetrahedra.hpp"

#include <array>
#include <string>
#include <utility>

namespace fem {

/// The element shapes this solver knows.
enum class ElementType { tri3, tri6, quad4, quad8, quad9, tet4, tet10, hexa8, hexa20, hexa27 };

/// All of them with their names in the configuration.
inline constexpr std::array<std::pair<ElementType, const char*>, 10> element_names{{{ElementType::tri3, "tri3"},
                                                                                    {ElementType::tri6, "tri6"},
                                                                                    {ElementType::quad4, "quad4"},
                                                                                    {ElementType::quad8, "quad8"},
                                                                                    {ElementType::quad9, "quad9"},
                                                                                    {ElementType::tet4, "tet4"},
                                                                                    {ElementType::tet10, "tet10"},
                                                                                    {ElementType::hexa8, "hexa8"},
                                                                                    {ElementType::hexa20, "hexa20"},
                                                                                    {ElementType::hexa27, "hexa27"}}};

/// Calls `action(Shape{})` with the shape class of a type; returns what the action returns.
template<class Action> auto with_shape(ElementType type, Action&& action)
{
    switch (type) {
    case ElementType::tri3:
        return action(Tri3{});
    case ElementType::tri6:
        return action(Tri6{});
    case ElementType::quad4:
        return action(Quad4{});
    case ElementType::quad8:
        return action(Quad8{});
    case ElementType::quad9:
        return action(Quad9{});
    case ElementType::tet4:
        return action(Tet4{});
    case ElementType::tet10:
        return action(Tet10{});
    case ElementType::hexa8:
        return action(Hexa8{});
    case ElementType::hexa20:
        return action(Hexa20{});
    default:
        return action(Hexa27{});
    }
}

inline int dimension_of(ElementType type)
{
    return with_shape(type, [](auto shape) { return shape.dimension; });
}

inline std::string name_of(ElementType type) { return element_names[static_cast<std::size_t>(type)].second; }

/// Whether a shape is a triangle or tetrahedron.
template<class Shape> constexpr bool is_simplex = requires { Shape::simplex; };

} // namespace fem

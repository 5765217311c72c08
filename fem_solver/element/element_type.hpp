// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/hexahedra.hpp"

#include <string>

namespace fem {

/// The element shapes this solver knows. Names as in the configuration: "quad4", "quad8", "hexa8", "hexa20".
enum class ElementType { quad4, quad8, hexa8, hexa20 };

/// Calls `action(Shape{})` with the shape class of a type; returns what the action returns.
template<class Action> auto with_shape(ElementType type, Action&& action)
{
    switch (type) {
    case ElementType::quad4:
        return action(Quad4{});
    case ElementType::quad8:
        return action(Quad8{});
    case ElementType::hexa8:
        return action(Hexa8{});
    default:
        return action(Hexa20{});
    }
}

inline int dimension_of(ElementType type) { return type == ElementType::quad4 || type == ElementType::quad8 ? 2 : 3; }

inline std::string name_of(ElementType type)
{
    switch (type) {
    case ElementType::quad4:
        return "quad4";
    case ElementType::quad8:
        return "quad8";
    case ElementType::hexa8:
        return "hexa8";
    default:
        return "hexa20";
    }
}

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace sph {

/// What a field is to the machinery that moves particles about.
///   conserved  integrated in time: migrates with its particle, is sent to halo copies after each stage, is restarted
///   derived    follows from the conserved fields: recomputed, or sent to halo copies where it costs a neighbour sum
///   scratch    lives within one evaluation, never leaves its rank
enum class Role { conserved, derived, scratch };

/// One line of the field table: how a field is called, written and measured.
struct FieldInfo {
    std::string_view name;    ///< in files and code
    std::string_view symbol;  ///< in formulas
    std::string_view unit;    ///< in 3D; see `unit_2d`
    std::string_view unit_2d; ///< per metre of depth
    std::string_view description;
    Role role;

    [[nodiscard]] constexpr std::string_view unit_in(int dimension) const { return dimension == 2 ? unit_2d : unit; }
};

/// A table entry: the description and the column of `Container` that holds the values.
template<class Container, class T> struct Field {
    FieldInfo info;
    T Container::*column;
};

} // namespace sph

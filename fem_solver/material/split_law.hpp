// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/material.hpp"

#include <optional>

namespace fem {

/// A law with energy psi(shape) + K/2 (J - 1)^2, in its two parts.
struct SplitLaw {
    Law shape;   ///< psi alone: the same law with K = 0
    double bulk; ///< K [Pa]
};

/// The two parts of a law; nothing for laws that do not separate shape and volume (SmallElastic, SaintVenantKirchhoff,
/// NeoHookeanLog).
inline std::optional<SplitLaw> split(const Law& law)
{
    return std::visit(
        []<class LawType>(LawType shape) -> std::optional<SplitLaw> {
            if constexpr (std::is_same_v<LawType, NeoHookean>) {
                const double bulk = shape.lame.bulk();
                shape.lame.lambda = -2 * shape.lame.mu / 3;
                return SplitLaw{shape, bulk};
            } else if constexpr (requires { shape.bulk; }) {
                const double bulk = shape.bulk;
                shape.bulk = 0;
                return SplitLaw{shape, bulk};
            } else {
                return std::nullopt;
            }
        },
        law);
}

} // namespace fem

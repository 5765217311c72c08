// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/material.hpp"

#include <string>

namespace fem {

/// Where a law is stable in Drucker's sense: d(Kirchhoff stress) : d(logarithmic strain) > 0 for every small change of
/// the principal strains, at states that keep the volume.
///
///     uniaxial (l, l^-1/2, l^-1/2),   equibiaxial (l, l, l^-2),   planar (l, 1, 1/l)
struct StabilityReport {
    bool stable = true;
    std::string text; ///< one line for the log: the range, or the first stretch on each path that is not stable
};

/// \param lowest, highest principal stretch l examined, lowest < 1 < highest.
StabilityReport drucker_stability(const Law& law, double lowest, double highest);

} // namespace fem

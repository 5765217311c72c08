// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/coupling/surface.hpp"

#include <string>
#include <vector>

namespace coupler {

/// Looks at every motion before it is sent: a value that is not a number, or a node that moved farther in one step
/// than the limit times the mean facet size, stops the run.
class MotionGuard {
public:
    /// \param limit  largest move in a step, in mean facet sizes of `surface` (of this rank) [-]
    MotionGuard(const WetSurface& surface, double limit);

    /// Throws base::Error(numerical_failure) naming node, position and `sender`. \param who e.g. "'solid' (rank 1, ...)"
    void check(const WetSurface& surface, const SurfaceMotion& motion, const std::string& who);

private:
    double longest_move_;               ///< [m]
    std::vector<double> last_position_; ///< of the last motion that passed
};

/// Throws base::Error(numerical_failure) when the load on a facet, as a pressure, is beyond `limit` [Pa]; names facet,
/// position and sender. Sums are never NaN: base::ReproducibleSum refuses such terms.
void check_loads(const FacetBatch& facets, const FacetLoads& loads, double limit, const std::string& who);

/// Throws base::Error(bad_input) on a surface that cannot be: see SolidInterface.
void check_surface(const WetSurface& surface, const std::string& who);

} // namespace coupler

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/walls/mirror_plane.hpp"
#include "sph_solver/walls/touching.hpp"

#include <vector>

namespace sph {

/// Spreads the touch of a particle on a moving wall over the width that a particle stands for.
///
/// A solid's mesh may be much finer than the particles. Were the force of a particle given to the one point x_w, it would
/// shake surface nodes that no particle feels, and a mode that is coupled in one direction only can grow. So the wall point of
/// a plane moves as the mean over its footprint, and the footprint takes the force with the same weights:
///
///     v_w = sum_n H_n v_n,   f_n = H_n F,   H_n = sum over samples s of  A_s hat(|x_s - x_w| / dx) N_n(x_s)  / the sum of all,
///
/// hat(q) = max(1 - q, 0), samples at most dx/3 apart on the moving facets around, also beyond an edge. Power and force are thus the
/// same on both sides; the moment is that of a force at the footprint's centre, which is x_w but near edges.
template<int D> class FootprintFinder {
public:
    FootprintFinder(const WallFacets<D>& facets, const Touching<D>& touching, const WallSettings<D>& settings);

    /// Appends the footprint of a plane on a moving facet and sets the plane's share in it, its velocity and acceleration.
    void append(MirrorPlane<D>& plane, std::vector<FootprintPart<D>>& parts);

private:
    void gather_sheet(const MirrorPlane<D>& plane);
    FootprintPart<D> weigh(int facet, const Vec<D>& centre) const;

    const WallFacets<D>& facets_;
    const Touching<D>& touching_;
    double radius_;          ///< dx [m]
    std::vector<int> sheet_; ///< facets within reach of the plane at hand
};

} // namespace sph

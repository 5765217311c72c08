// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/walls/mirror_plane.hpp"
#include "sph_solver/walls/touching.hpp"
#include "sph_solver/walls/wall_facets.hpp"

#include <span>
#include <vector>

namespace sph {

/// Cosine beyond which two faces are the two sides of a plate or a sharp wedge: nobody sees from one to the other. (120
/// degrees and a little more, so that rounding does not decide on wedges of 60 degrees.)
inline constexpr double cos_opposite = -0.5001;

/// Finds the planes in which the neighbours of a particle are mirrored.
///
/// The nearest point of all facets gives the first plane, with n = (x_i - x_w)/|x_i - x_w|, turned outwards where the
/// particle is inside the wall; only where x_w is the concave joint with a sheet that has its plane, n is the facet's
/// own. Every facet that hangs together with this point through touching facets, and either is
/// turned away from n by less than the sheet angle or lies behind the plane (beyond a convex edge), is represented by
/// the plane. The nearest point of what is left gives the next plane, up to max_planes of them.
///
/// Where the body behind the plane ends at a convex edge or a free end, a cut is noted: beyond it there is fluid, and
/// an
/// image there would count space twice.
template<int D> class ContactFinder {
public:
    ContactFinder(const WallFacets<D>& facets, const Touching<D>& touching, const WallSettings<D>& settings);

    /// Appends the planes of a particle at x, nearest first. \param candidates all facets within the support,
    /// ascending.
    void append_planes(const Vec<D>& x, std::span<const int> candidates, std::vector<MirrorPlane<D>>& planes);

private:
    struct Near {
        int facet;
        base::ClosestPoint<D> closest;
        double height; ///< of the particle over the facet's plane [m]
        bool represented;
    };
    void gather(const Vec<D>& x, std::span<const int> candidates);
    int nearest() const;
    static bool is_on_side(const Near& near);
    Vec<D> face_normal(int at) const;
    bool is_beyond_end(int at, const Vec<D>& from_wall) const;
    bool is_at_represented_joint(int at) const;
    MirrorPlane<D> plane_at(const Vec<D>& x, int at) const;
    bool is_usable(const MirrorPlane<D>& plane, const std::vector<MirrorPlane<D>>& planes, std::size_t first) const;
    void mark_represented(MirrorPlane<D>& plane, int at);
    bool represents(const MirrorPlane<D>& plane, int facet) const;
    bool lies_behind(const MirrorPlane<D>& plane, int facet) const;
    void drop_covered_cuts(MirrorPlane<D>& plane) const;
    void add_cuts(MirrorPlane<D>& plane, int facet) const;
    bool is_shut(const MirrorPlane<D>& plane, int facet) const;
    void add_sight_cuts(MirrorPlane<D>& plane, int facet) const;
    void add_cut(MirrorPlane<D>& plane, const Vec<D>& normal, const Vec<D>& point) const;

    const WallFacets<D>& facets_;
    const Touching<D>& touching_;
    double support_, spacing_, tolerance_, push_from_, push_rate_, cos_sheet_;
    std::vector<Near> near_;
    std::vector<int> queue_;
};

} // namespace sph

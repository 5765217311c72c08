// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/walls/wall_facets.hpp"

#include <span>
#include <utility>
#include <vector>

namespace sph {

/// Which facets touch which, also of different bodies: two facets touch when they come nearer than a tolerance.
/// And which sides of a facet are free: nothing touches them. Side s of a facet lies opposite to its corner s: the other end
/// of a segment, an edge of a triangle.
template<int D> class Touching {
public:
    /// \param tolerance [m], a small part of the particle spacing. What facets that stand still have with each other is found
    /// once for each number of them.
    void find(const WallFacets<D>& facets, double tolerance);

    /// Facets that touch this one, ascending.
    std::span<const int> of(int facet) const
    {
        const auto f = static_cast<std::size_t>(facet);
        return {touching_.data() + offsets_[f], static_cast<std::size_t>(offsets_[f + 1] - offsets_[f])};
    }
    /// Does the wall end at this side of the facet? (3D: at its middle and near both ends; a side that is met in part is
    /// not free.)
    bool is_free_side(int facet, int side) const
    {
        return met_side_[static_cast<std::size_t>(facet) * D + static_cast<std::size_t>(side)] == 0;
    }

private:
    using Pair = std::pair<int, int>;
    using Boxes = std::vector<base::Box<D>>;
    static void append_pairs(const WallFacets<D>& facets, const Boxes& boxes, int first_moving, double tolerance,
                             std::vector<Pair>& pairs);
    void set_pairs(std::vector<Pair>& pairs, int facets);
    void find_still(const WallFacets<D>& facets, const Boxes& boxes, double tolerance);
    void find_met_sides(const WallFacets<D>& facets, int facet, int from, double tolerance);

    std::vector<int> offsets_{0}, touching_;
    std::vector<char> met_side_;
    std::vector<Pair> still_pairs_;  ///< of the first `still_` facets
    std::vector<char> met_by_still_; ///< their sides
    int still_ = -1;
};

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/walls/wall_facets.hpp"

#include <span>
#include <vector>

namespace sph {

/// Which facets touch which, also of different bodies: two facets touch when they come nearer than a tolerance.
/// And which ends of a wall are free: nothing touches them.
template<int D> class Touching {
public:
    /// \param tolerance [m], a small part of the particle spacing.
    void find(const WallFacets<D>& facets, double tolerance);

    /// Facets that touch this one, ascending.
    std::span<const int> of(int facet) const
    {
        const auto f = static_cast<std::size_t>(facet);
        return {touching_.data() + offsets_[f], static_cast<std::size_t>(offsets_[f + 1] - offsets_[f])};
    }
    /// 2D: does the wall end at this corner of the facet? Always false in 3D.
    bool is_free_end(int facet, int corner) const
    {
        return free_end_[static_cast<std::size_t>(facet) * D + static_cast<std::size_t>(corner)] != 0;
    }

private:
    void find_free_ends(const WallFacets<D>& facets, double tolerance);

    std::vector<int> offsets_{0}, touching_;
    std::vector<char> free_end_;
};

} // namespace sph

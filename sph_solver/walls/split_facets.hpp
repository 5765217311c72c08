// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/walls/wall_facets.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace sph {

/// Facets given by up to four vertices (-1: unused) as segments or triangles. A quadrilateral becomes the triangles
/// (0, 1, 2) and (0, 2, 3), so that its points follow the corners linearly. `source` is the index in `facets`.
template<int D> std::vector<WallFacet<D>> split_facets(const std::vector<std::array<int, 4>>& facets)
{
    std::vector<WallFacet<D>> pieces;
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const auto add = [&](const std::array<int, D>& corner) {
            WallFacet<D> piece;
            piece.source = static_cast<int>(f);
            piece.corner = corner;
            for (std::size_t c = 0; c < D; ++c) piece.vertex[c] = facets[f][static_cast<std::size_t>(corner[c])];
            pieces.push_back(piece);
        };
        if constexpr (D == 2) {
            add({0, 1});
        } else {
            add({0, 1, 2});
            if (facets[f][3] >= 0) add({0, 2, 3});
        }
    }
    return pieces;
}

} // namespace sph

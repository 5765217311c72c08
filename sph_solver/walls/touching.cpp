// SPDX-License-Identifier: MIT
#include "sph_solver/walls/touching.hpp"

#include <algorithm>
#include <numeric>

namespace sph {

template<int D> void Touching<D>::find(const WallFacets<D>& facets, double tolerance)
{
    std::vector<base::Box<D>> boxes;
    for (int f = 0; f < facets.size(); ++f) boxes.push_back(base::box_around<D>(facets.corners(f)).widened(tolerance));
    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    const int axis = D - 1; // walls are taller than they are thick
    const auto box = [&](int f) -> const base::Box<D>& { return boxes[static_cast<std::size_t>(f)]; };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return box(a).low[axis] < box(b).low[axis]; });

    std::vector<std::pair<int, int>> pairs;
    for (std::size_t a = 0; a < order.size(); ++a) {
        for (std::size_t b = a + 1; b < order.size() && box(order[b]).low[axis] <= box(order[a]).high[axis]; ++b) {
            const int f = order[a], g = order[b];
            if (!box(f).touches(box(g))) continue;
            if (base::simplex_distance<D>(facets.corners(f), facets.corners(g)) > tolerance) continue;
            pairs.emplace_back(f, g);
            pairs.emplace_back(g, f);
        }
    }
    std::sort(pairs.begin(), pairs.end());
    offsets_.assign(boxes.size() + 1, 0);
    touching_.clear();
    for (const auto& [f, g] : pairs) {
        ++offsets_[static_cast<std::size_t>(f) + 1];
        touching_.push_back(g);
    }
    std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
    find_free_ends(facets, tolerance);
}

template<int D> void Touching<D>::find_free_ends(const WallFacets<D>& facets, double tolerance)
{
    free_end_.assign(static_cast<std::size_t>(facets.size()) * D, 0);
    if (D == 3) return;
    for (int f = 0; f < facets.size(); ++f) {
        for (int c = 0; c < D; ++c) {
            const auto& end = facets.corners(f)[static_cast<std::size_t>(c)];
            const auto neighbours = of(f);
            const bool met = std::any_of(neighbours.begin(), neighbours.end(), [&](int g) {
                return base::closest_point(facets.corners(g), end).squared_distance <= tolerance * tolerance;
            });
            free_end_[static_cast<std::size_t>(f) * D + static_cast<std::size_t>(c)] = !met;
        }
    }
}

template class Touching<2>;
template class Touching<3>;

} // namespace sph

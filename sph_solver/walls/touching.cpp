// SPDX-License-Identifier: MIT
#include "sph_solver/walls/touching.hpp"

#include <algorithm>
#include <numeric>

namespace sph {
namespace {

/// Where a side is asked whether something touches it.
std::array<Vec<2>, 1> points_of_side(const base::Simplex<2>& corners, std::size_t side) { return {corners[1 - side]}; }
std::array<Vec<3>, 3> points_of_side(const base::Simplex<3>& corners, std::size_t side)
{
    const Vec<3>&a = corners[(side + 1) % 3], &b = corners[(side + 2) % 3];
    return {a + (b - a) / 6, a + (b - a) / 2, b - (b - a) / 6};
}

} // namespace

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
    find_free_sides(facets, tolerance);
}

template<int D> void Touching<D>::find_free_sides(const WallFacets<D>& facets, double tolerance)
{
    free_side_.assign(static_cast<std::size_t>(facets.size()) * D, 0);
    for (int f = 0; f < facets.size(); ++f) {
        const auto is_met = [&](const Vec<D>& x) {
            const auto neighbours = of(f);
            return std::any_of(neighbours.begin(), neighbours.end(), [&](int g) {
                return base::closest_point(facets.corners(g), x).squared_distance <= tolerance * tolerance;
            });
        };
        for (int s = 0; s < D; ++s) {
            const auto points = points_of_side(facets.corners(f), static_cast<std::size_t>(s));
            free_side_[static_cast<std::size_t>(f) * D + static_cast<std::size_t>(s)] =
                std::none_of(points.begin(), points.end(), is_met);
        }
    }
}

template class Touching<2>;
template class Touching<3>;

} // namespace sph

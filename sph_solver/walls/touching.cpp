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

/// The pairs of facets that touch, each both ways; pairs of facets before `first_moving` are left out. Boxes are swept along
/// the longest side of the box around all.
template<int D>
void Touching<D>::append_pairs(const WallFacets<D>& facets, const Boxes& boxes, int first_moving, double tolerance,
                               std::vector<Pair>& pairs)
{
    Vec<D> low = boxes.empty() ? Vec<D>::Zero().eval() : boxes.front().low, high = low;
    for (const auto& box : boxes) {
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    const auto box = [&](int f) -> const base::Box<D>& { return boxes[static_cast<std::size_t>(f)]; };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return box(a).low[axis] < box(b).low[axis]; });
    for (std::size_t a = 0; a < order.size(); ++a) {
        for (std::size_t b = a + 1; b < order.size() && box(order[b]).low[axis] <= box(order[a]).high[axis]; ++b) {
            const int f = order[a], g = order[b];
            if ((f < first_moving && g < first_moving) || !box(f).touches(box(g))) continue;
            if (base::simplex_distance<D>(facets.corners(f), facets.corners(g)) > tolerance) continue;
            pairs.emplace_back(f, g);
            pairs.emplace_back(g, f);
        }
    }
}

template<int D> void Touching<D>::find(const WallFacets<D>& facets, double tolerance)
{
    Boxes boxes;
    for (int f = 0; f < facets.size(); ++f) boxes.push_back(base::box_around<D>(facets.corners(f)).widened(tolerance));
    const int still = facets.still_facets();
    if (still_ != still) find_still(facets, Boxes(boxes.begin(), boxes.begin() + still), tolerance);
    std::vector<Pair> pairs = still_pairs_;
    append_pairs(facets, boxes, still, tolerance, pairs);
    set_pairs(pairs, facets.size());
    met_side_ = met_by_still_;
    met_side_.resize(static_cast<std::size_t>(facets.size()) * D, 0);
    for (int f = 0; f < facets.size(); ++f) find_met_sides(facets, f, f < still ? still : 0, tolerance);
}

/// What does not change: the pairs among facets that stand still, and their sides that are met by such facets.
template<int D> void Touching<D>::find_still(const WallFacets<D>& facets, const Boxes& boxes, double tolerance)
{
    still_ = static_cast<int>(boxes.size());
    still_pairs_.clear();
    append_pairs(facets, boxes, 0, tolerance, still_pairs_);
    set_pairs(still_pairs_, still_);
    met_side_.assign(boxes.size() * D, 0);
    for (int f = 0; f < still_; ++f) find_met_sides(facets, f, 0, tolerance);
    met_by_still_ = met_side_;
}

template<int D> void Touching<D>::set_pairs(std::vector<Pair>& pairs, int facets)
{
    std::sort(pairs.begin(), pairs.end());
    offsets_.assign(static_cast<std::size_t>(facets) + 1, 0);
    touching_.clear();
    for (const auto& [f, g] : pairs) {
        ++offsets_[static_cast<std::size_t>(f) + 1];
        touching_.push_back(g);
    }
    std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
}

/// Adds to the sides of a facet that are met those that facets from number `from` on meet.
template<int D> void Touching<D>::find_met_sides(const WallFacets<D>& facets, int facet, int from, double tolerance)
{
    const auto all = of(facet);
    const std::span<const int> others(std::lower_bound(all.begin(), all.end(), from), all.end());
    if (others.empty()) return;
    const auto is_met = [&](const Vec<D>& x) {
        return std::any_of(others.begin(), others.end(), [&](int g) {
            return base::closest_point(facets.corners(g), x).squared_distance <= tolerance * tolerance;
        });
    };
    for (std::size_t s = 0; s < D; ++s) {
        char& met = met_side_[static_cast<std::size_t>(facet) * D + s];
        const auto points = points_of_side(facets.corners(facet), s);
        met = met != 0 || std::any_of(points.begin(), points.end(), is_met);
    }
}

template class Touching<2>;
template class Touching<3>;

} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/walls/footprint.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

constexpr double cos_far_side = -0.5; // a footprint goes round edges, not to the far side of a plate
constexpr double samples_per_radius = 3.0;

/// Calls visit(shape functions) for the samples of a facet cut in n parts along each edge; all stand for the same measure.
template<class Visit> void for_each_sample(const base::Simplex<2>&, int n, Visit&& visit)
{
    for (int k = 0; k < n; ++k) {
        const double s = (k + 0.5) / n;
        visit(std::array<double, 2>{1 - s, s});
    }
}
template<class Visit> void for_each_sample(const base::Simplex<3>&, int n, Visit&& visit)
{
    const auto at = [&](double i, double j) { visit(std::array<double, 3>{1 - (i + j) / n, i / n, j / n}); };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n - i; ++j) {
            at(i + 1.0 / 3, j + 1.0 / 3);
            if (j < n - i - 1) at(i + 2.0 / 3, j + 2.0 / 3);
        }
}

template<int D> int parts_along_edge(const base::Simplex<D>& corners, double radius)
{
    double longest = 0;
    for (std::size_t c = 0; c < D; ++c) longest = std::max(longest, (corners[(c + 1) % D] - corners[c]).norm());
    return std::max(1, static_cast<int>(std::ceil(samples_per_radius * longest / radius)));
}

template<int D> Vec<D> point_at(const base::Simplex<D>& corners, const std::array<double, D>& shape)
{
    Vec<D> x = Vec<D>::Zero();
    for (std::size_t c = 0; c < D; ++c) x += shape[c] * corners[c];
    return x;
}

} // namespace

template<int D>
FootprintFinder<D>::FootprintFinder(const WallFacets<D>& facets, const Touching<D>& touching,
                                    const WallSettings<D>& settings)
    : facets_(facets), touching_(touching), radius_(settings.spacing)
{}

template<int D> void FootprintFinder<D>::append(MirrorPlane<D>& plane, std::vector<FootprintPart<D>>& parts)
{
    plane.footprint_begin = static_cast<int>(parts.size());
    double sum = 0;
    gather_sheet(plane);
    for (const int facet : sheet_) {
        parts.push_back(weigh(facet, plane.point));
        for (const double share : parts.back().weight) sum += share;
    }
    plane.footprint_end = static_cast<int>(parts.size());
    plane.velocity = plane.acceleration = Vec<D>::Zero();
    for (auto part = parts.begin() + plane.footprint_begin; part != parts.end(); ++part) {
        for (double& share : part->weight) share /= sum;
        plane.velocity += facets_.velocity(part->facet, part->weight);
        plane.acceleration += facets_.acceleration(part->facet, part->weight);
    }
}

/// From touching facet to touching facet, as far as the footprint reaches, also round an edge.
template<int D> void FootprintFinder<D>::gather_sheet(const MirrorPlane<D>& plane)
{
    sheet_.assign(1, plane.facet);
    const Vec<D>& normal = facets_.normal(plane.facet);
    for (std::size_t head = 0; head < sheet_.size(); ++head)
        for (const int other : touching_.of(sheet_[head])) {
            if (!facets_.is_wet(other) || std::find(sheet_.begin(), sheet_.end(), other) != sheet_.end()) continue;
            if (facets_.normal(other).dot(normal) < cos_far_side) continue;
            const auto closest = base::closest_point(facets_.corners(other), plane.point);
            if (closest.squared_distance < radius_ * radius_) sheet_.push_back(other);
        }
    std::sort(sheet_.begin(), sheet_.end());
}

template<int D> FootprintPart<D> FootprintFinder<D>::weigh(int facet, const Vec<D>& centre) const
{
    const base::Simplex<D>& corners = facets_.corners(facet);
    const int n = parts_along_edge<D>(corners, radius_);
    const double measure = base::area_vector(corners).norm() / (D == 2 ? n : n * n);
    FootprintPart<D> part{facet, {}};
    for_each_sample(corners, n, [&](const std::array<double, D>& shape) {
        const double hat = std::max(0.0, 1.0 - (point_at<D>(corners, shape) - centre).norm() / radius_);
        for (std::size_t c = 0; c < D; ++c) part.weight[c] += measure * hat * shape[c];
    });
    return part;
}

template class FootprintFinder<2>;
template class FootprintFinder<3>;

} // namespace sph

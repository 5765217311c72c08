// SPDX-License-Identifier: MIT
#include "sph_solver/walls/contact_finder.hpp"

#include "sph_solver/walls/facet_sides.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace sph {

namespace {
constexpr double touch_tolerance = 0.05; // [dx]
constexpr double shut_gap = 0.25;        // [dx] a narrower gap between two faces holds no fluid
constexpr double deepest_inside = 0.5;   // [dx] deeper than this, a particle is on the other side of the wall
constexpr double cos_flat = 0.99985;     // facets within 1 degree of the plane need no cut

} // namespace

template<int D>
ContactFinder<D>::ContactFinder(const WallFacets<D>& facets, const Touching<D>& touching,
                                const WallSettings<D>& settings)
    : facets_(facets),
      touching_(touching),
      support_(settings.support),
      spacing_(settings.spacing),
      tolerance_(touch_tolerance * settings.spacing),
      push_from_(settings.push_from * settings.spacing),
      push_rate_(settings.push_rate),
      cos_sheet_(std::cos(settings.sheet_angle * std::numbers::pi / 180.0))
{}

template<int D>
void ContactFinder<D>::append_planes(const Vec<D>& x, std::span<const int> candidates,
                                     std::vector<MirrorPlane<D>>& planes)
{
    gather(x, candidates);
    const std::size_t first = planes.size();
    for (int at = nearest(); at >= 0 && planes.size() < first + max_planes; at = nearest()) {
        MirrorPlane<D> plane = plane_at(x, at);
        near_[static_cast<std::size_t>(at)].represented = true;
        if (!is_usable(plane, planes, first)) continue;
        mark_represented(plane, at);
        planes.push_back(std::move(plane));
    }
}

template<int D> void ContactFinder<D>::gather(const Vec<D>& x, std::span<const int> candidates)
{
    near_.clear();
    for (const int facet : candidates) {
        const auto closest = base::closest_point(facets_.corners(facet), x);
        if (closest.squared_distance >= support_ * support_) continue;
        near_.push_back({facet, closest, (x - closest.point).dot(facets_.normal(facet)), false});
    }
}

/// Position in `near_` of the nearest facet that no plane represents yet, -1 if there is none. Of facets in the same place
/// (the two faces of a plate without thickness, the facets around a corner) the one that looks at the particle.
template<int D> int ContactFinder<D>::nearest() const
{
    const Near* best = nullptr;
    for (const Near& near : near_) {
        if (near.represented) continue;
        const double gain = best ? best->closest.squared_distance - near.closest.squared_distance : support_ * support_;
        const bool same_place = std::abs(gain) <= 1e-12 * spacing_ * spacing_;
        if (same_place ? near.height > best->height : gain > 0) best = &near;
    }
    return best ? static_cast<int>(best - near_.data()) : -1;
}

template<int D> bool ContactFinder<D>::is_on_side(const Near& near)
{
    return *std::min_element(near.closest.weight.begin(), near.closest.weight.end()) <= 0;
}

/// Mean normal of the facets that share the nearest point, weighted by the angles that they take up around it: its sign
/// tells inside from outside at any edge and corner (Baerentzen and Aanaes 2005).
template<int D> Vec<D> ContactFinder<D>::face_normal(int at) const
{
    const Near& base = near_[static_cast<std::size_t>(at)];
    const auto touching = touching_.of(base.facet);
    if (!is_on_side(base)) return facets_.normal(base.facet);
    Vec<D> sum = angle_at(facets_.corners(base.facet), base.closest.weight) * facets_.normal(base.facet);
    for (const Near& other : near_) {
        if ((other.closest.point - base.closest.point).norm() > 1e-9 * spacing_ || other.facet == base.facet) continue;
        if (std::binary_search(touching.begin(), touching.end(), other.facet))
            sum += angle_at(facets_.corners(other.facet), other.closest.weight) * facets_.normal(other.facet);
    }
    return sum.norm() > 0.1 ? Vec<D>(sum.normalized()) : facets_.normal(base.facet);
}

/// Is the nearest point a free end, and the particle beyond it? There it cannot be inside.
template<int D> bool ContactFinder<D>::is_beyond_end(int at, const Vec<D>& from_wall) const
{
    const Near& base = near_[static_cast<std::size_t>(at)];
    for (int s = 0; s < D; ++s) {
        if (base.closest.weight[static_cast<std::size_t>(s)] > 0 || !touching_.is_free_side(base.facet, s)) continue;
        if (from_wall.dot(away_from_side(facets_.corners(base.facet), s)) > 0) return true;
    }
    return false;
}

/// Is the nearest point a concave joint with a sheet that has its plane already? The wall then keeps its own normal:
/// there is
/// no edge that the particle could see.
template<int D> bool ContactFinder<D>::is_at_represented_joint(int at) const
{
    const Near& base = near_[static_cast<std::size_t>(at)];
    if (!is_on_side(base)) return false;
    const auto touching = touching_.of(base.facet);
    for (const Near& other : near_) {
        if (!other.represented || !std::binary_search(touching.begin(), touching.end(), other.facet)) continue;
        const auto closest = base::closest_point(facets_.corners(other.facet), base.closest.point);
        if (closest.squared_distance <= tolerance_ * tolerance_) return true;
    }
    return false;
}

template<int D> MirrorPlane<D> ContactFinder<D>::plane_at(const Vec<D>& x, int at) const
{
    const Near& base = near_[static_cast<std::size_t>(at)];
    const Vec<D> face = face_normal(at);
    MirrorPlane<D> plane;
    plane.facet = base.facet;
    plane.weight = base.closest.weight;
    plane.point = base.closest.point;
    const Vec<D> from_wall = x - plane.point;
    const double distance = from_wall.norm();
    const bool outside = from_wall.dot(face) >= 0 || is_beyond_end(at, from_wall);
    plane.distance = outside ? distance : -distance;
    plane.normal = distance > 1e-6 * spacing_ ? Vec<D>(from_wall / plane.distance) : face;
    if (is_at_represented_joint(at)) {
        plane.normal = facets_.normal(plane.facet);
        plane.distance = from_wall.dot(plane.normal);
    }
    plane.push = push_rate_ * std::max(0.0, push_from_ - plane.distance);
    plane.velocity = facets_.velocity(plane.facet, plane.weight);
    plane.acceleration = facets_.acceleration(plane.facet, plane.weight);
    plane.no_slip = facets_.body_of(plane.facet).no_slip;
    return plane;
}

/// Not the far side of a wall: a particle far inside stands on its other side, and so does one that is inside of a face
/// that looks away from a nearer one.
template<int D>
bool ContactFinder<D>::is_usable(const MirrorPlane<D>& plane, const std::vector<MirrorPlane<D>>& planes,
                                 std::size_t first) const
{
    if (plane.distance >= 0) return true;
    if (plane.distance < -deepest_inside * spacing_) return false;
    for (std::size_t p = first; p < planes.size(); ++p)
        if (plane.normal.dot(planes[p].normal) < cos_opposite) return false;
    return true;
}

/// Marks every facet that the plane stands for, going from touching facet to touching facet, and notes the cuts.
template<int D> void ContactFinder<D>::mark_represented(MirrorPlane<D>& plane, int at)
{
    queue_.assign(1, near_[static_cast<std::size_t>(at)].facet);
    for (std::size_t head = 0; head < queue_.size(); ++head) {
        const int facet = queue_[head];
        add_cuts(plane, facet);
        const auto touching = touching_.of(facet);
        for (Near& other : near_) {
            if (other.represented || !std::binary_search(touching.begin(), touching.end(), other.facet)) continue;
            if (!represents(plane, other.facet)) continue;
            other.represented = true;
            queue_.push_back(other.facet);
        }
    }
    drop_covered_cuts(plane);
}

/// Where the sheet goes on in front of a cut, the body does too: a wall that meets the gate flush may have a face
/// inside.
template<int D> void ContactFinder<D>::drop_covered_cuts(MirrorPlane<D>& plane) const
{
    std::erase_if(plane.cuts, [&](const Cut<D>& cut) {
        return std::any_of(queue_.begin(), queue_.end(), [&](int facet) {
            if (facets_.normal(facet).dot(plane.normal) < cos_sheet_) return false;
            const auto& corners = facets_.corners(facet);
            return std::any_of(corners.begin(), corners.end(),
                               [&](const Vec<D>& x) { return cut.normal.dot(x) > cut.offset + tolerance_; });
        });
    });
}

template<int D> bool ContactFinder<D>::represents(const MirrorPlane<D>& plane, int facet) const
{
    return facets_.normal(facet).dot(plane.normal) >= cos_sheet_ || lies_behind(plane, facet);
}

template<int D> bool ContactFinder<D>::lies_behind(const MirrorPlane<D>& plane, int facet) const
{
    for (const auto& corner : facets_.corners(facet))
        if ((corner - plane.point).dot(plane.normal) > tolerance_) return false;
    return true;
}

template<int D> void ContactFinder<D>::add_cuts(MirrorPlane<D>& plane, int facet) const
{
    const auto& corners = facets_.corners(facet);
    const Vec<D>& normal = facets_.normal(facet);
    const double turn = normal.dot(plane.normal);
    if (turn < cos_flat && lies_behind(plane, facet)) {
        if (turn < cos_opposite)
            add_sight_cuts(plane, facet);
        else if (!is_shut(plane, facet))
            add_cut(plane, normal, corners[0]);
    }
    for (int c = 0; c < D; ++c) {
        const int side = (c + D - 1) % D;
        if (touching_.is_free_side(facet, side))
            add_cut(plane, away_from_side(corners, side), corners[static_cast<std::size_t>(c)]);
    }
}

/// Does another body stand right before the facet, so that there is no fluid to cut for?
template<int D> bool ContactFinder<D>::is_shut(const MirrorPlane<D>& plane, int facet) const
{
    const Vec<D> nearest = base::closest_point(facets_.corners(facet), plane.point).point;
    const double gap = shut_gap * spacing_;
    return std::any_of(near_.begin(), near_.end(), [&](const Near& near) {
        return facets_[near.facet].body != facets_[facet].body &&
               facets_.normal(near.facet).dot(facets_.normal(facet)) < -0.9 &&
               base::closest_point(facets_.corners(near.facet), nearest).squared_distance < gap * gap;
    });
}

/// The far face of a wedge or a plate hides what is beyond it, but for what the particle sees past their common edge: a
/// cut through the particle and the edge.
template<int D> void ContactFinder<D>::add_sight_cuts(MirrorPlane<D>& plane, int facet) const
{
    const auto& corners = facets_.corners(facet);
    const Vec<D> x = plane.point + plane.distance * plane.normal;
    for (int s = 0; s < D; ++s) {
        const Vec<D> on_side = middle_of_side(corners, s);
        const bool is_edge = std::any_of(near_.begin(), near_.end(), [&](const Near& near) {
            if (facets_.normal(near.facet).dot(plane.normal) < cos_opposite) return false;
            const auto closest = base::closest_point(facets_.corners(near.facet), on_side);
            return closest.squared_distance <= tolerance_ * tolerance_;
        });
        const Vec<D> normal = past_side(x, corners, s);
        if (is_edge && normal.norm() > tolerance_ * spacing_) add_cut(plane, normal.normalized(), on_side);
    }
}

/// A cut counts only where it leaves the plane's own point in the body, within the particle's sight, and once.
template<int D> void ContactFinder<D>::add_cut(MirrorPlane<D>& plane, const Vec<D>& normal, const Vec<D>& point) const
{
    const double offset = normal.dot(point);
    if (plane.cuts.size() == MirrorPlane<D>::max_cuts || normal.dot(plane.point) > offset + tolerance_) return;
    if (normal.dot(plane.point + plane.distance * plane.normal) < offset - support_) return;
    for (const Cut<D>& cut : plane.cuts)
        if (normal.dot(cut.normal) > cos_flat && std::abs(offset - cut.offset) < tolerance_) return;
    const double turn = normal.dot(plane.normal);
    plane.cuts.push_back({normal, offset, std::sqrt(std::max(1e-4, 1 - turn * turn))});
}

template class ContactFinder<2>;
template class ContactFinder<3>;

} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/interface/interface_loads.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sph {
namespace {

constexpr double reach = 1.5;       // [dx] particles of the averaged load
constexpr double cos_sheet = 0.766; // 40 degrees: facets of one patch

/// Length of a segment within the ball, area of a triangle whose centre is within it.
double measure_within(const base::Simplex<2>& corners, const Vec<2>& centre, double radius)
{
    const Vec<2> along = corners[1] - corners[0];
    const double length = along.norm();
    const double foot = (centre - corners[0]).dot(along) / length;
    const double square = radius * radius - (corners[0] + (foot / length) * along - centre).squaredNorm();
    if (square <= 0) return 0;
    const double half = std::sqrt(square);
    return std::max(0.0, std::min(length, foot + half) - std::max(0.0, foot - half));
}
double measure_within(const base::Simplex<3>& corners, const Vec<3>& centre, double radius)
{
    const Vec<3> middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    return (middle - centre).norm() <= radius ? base::area_vector(corners).norm() : 0.0;
}

} // namespace

template<int D> void InterfaceLoads<D>::begin(const Walls<D>& walls, std::size_t facet_count)
{
    loads_ = {};
    loads_.corner_force.resize(facet_count * 4 * D);
    if (!averaged_) return;
    loads_.weight.resize(facet_count);
    loads_.weighted_pressure.resize(facet_count);
    loads_.full_weight.assign(facet_count, 0.0);
    follow(walls);
}

template<int D> void InterfaceLoads<D>::follow(const Walls<D>& walls)
{
    if (!averaged_) return;
    patches_.assign(loads_.weight.size(), {});
    make_patches(walls);
}

template<int D> void InterfaceLoads<D>::make_patches(const Walls<D>& walls)
{
    const auto& facets = walls.facets();
    for (int f = facets.first_of_interface(); f < facets.size(); ++f) {
        Patch& patch = patches_[static_cast<std::size_t>(facets[f].source)];
        const Vec<D> area = base::area_vector(facets.corners(f));
        Vec<D> middle = Vec<D>::Zero();
        for (const auto& corner : facets.corners(f)) middle += corner / D;
        patch.area += area;
        patch.measure += area.norm();
        patch.moment += area.norm() * middle;
    }
    const double dx = settings_.spacing;
    grid_ = base::BoxGrid<D>(2 * dx);
    for (std::size_t f = 0; f < patches_.size(); ++f) {
        if (!is_small(patches_[f])) continue;
        base::Box<D> box;
        box.include(patches_[f].centre());
        grid_.add(static_cast<int>(f), box.widened(dx));
    }
    grid_.build();
    for (std::size_t f = 0; f < patches_.size(); ++f)
        loads_.full_weight[f] = reach * dx * patch_measure(walls, patches_[f]);
}

/// Shorter than 2 dx, or smaller than the disc of radius dx.
template<int D> bool InterfaceLoads<D>::is_small(const Patch& patch) const
{
    const double dx = settings_.spacing;
    return patch.measure < (D == 2 ? 2 * dx : std::numbers::pi * dx * dx);
}

template<int D> bool InterfaceLoads<D>::same_sheet(const Patch& patch, const Vec<D>& normal) const
{
    return patch.area.dot(normal) >= cos_sheet * patch.area.norm();
}

template<int D> double InterfaceLoads<D>::patch_measure(const Walls<D>& walls, const Patch& patch) const
{
    if (!is_small(patch)) return patch.measure;
    const auto& facets = walls.facets();
    const Vec<D> centre = patch.centre();
    double measure = 0;
    for (int f = facets.first_of_interface(); f < facets.size(); ++f)
        if (same_sheet(patch, facets.normal(f)))
            measure += measure_within(facets.corners(f), centre, settings_.spacing);
    return std::max(measure, patch.measure);
}

template<int D>
void InterfaceLoads<D>::add(const Particles<D>& particles, const Walls<D>& walls, const std::vector<Vec<D>>& on_wall,
                            double weight)
{
    const auto& facets = walls.facets();
    for (const WallContact& contact : walls.contacts().contacts) {
        for (auto p = static_cast<std::size_t>(contact.plane_begin); p < static_cast<std::size_t>(contact.plane_end);
             ++p) {
            const MirrorPlane<D>& plane = walls.contacts().planes[p];
            if (!facets.is_wet(plane.facet)) continue;
            add_force(walls, plane, weight * on_wall[p]);
            if (averaged_ && plane.distance < reach * settings_.spacing)
                add_average(particles, static_cast<std::size_t>(contact.particle), plane, facets[plane.facet].source,
                            facets.normal(plane.facet), weight);
        }
    }
}

/// Gives a force to the corners of its footprint.
template<int D>
void InterfaceLoads<D>::add_force(const Walls<D>& walls, const MirrorPlane<D>& plane, const Vec<D>& force)
{
    for (int part = plane.footprint_begin; part < plane.footprint_end; ++part) {
        const auto& [number, share] = walls.contacts().footprints[static_cast<std::size_t>(part)];
        const WallFacet<D>& facet = walls.facets()[number];
        for (std::size_t c = 0; c < D; ++c) {
            const auto corner = static_cast<std::size_t>(facet.source * 4 + facet.corner[c]);
            for (std::size_t a = 0; a < D; ++a)
                loads_.corner_force[corner * D + a].add(share[c] * force[static_cast<int>(a)]);
        }
    }
}

template<int D>
void InterfaceLoads<D>::add_average(const Particles<D>& particles, std::size_t i, const MirrorPlane<D>& plane,
                                    int source, const Vec<D>& normal, double weight)
{
    const Vec<D> to_wall = plane.point - particles.position[i];
    const double pressure =
        particles.pressure[i] + particles.density[i] * (settings_.gravity - plane.acceleration).dot(to_wall);
    const auto add_to = [&](std::size_t f) {
        loads_.weight[f].add(weight * particles.volume[i]);
        loads_.weighted_pressure[f].add(weight * particles.volume[i] * pressure);
    };
    const auto own = static_cast<std::size_t>(source);
    add_to(own);
    for (const int f : grid_.near(plane.point)) {
        const Patch& patch = patches_[static_cast<std::size_t>(f)];
        if (f == source || !same_sheet(patch, normal)) continue;
        if ((plane.point - patch.centre()).squaredNorm() <= settings_.spacing * settings_.spacing)
            add_to(static_cast<std::size_t>(f));
    }
}

template class InterfaceLoads<2>;
template class InterfaceLoads<3>;

} // namespace sph

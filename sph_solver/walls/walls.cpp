// SPDX-License-Identifier: MIT
#include "sph_solver/walls/walls.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/walls/footprint.hpp"
#include "sph_solver/walls/split_facets.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

template<int D> std::vector<Vec<D>> points(const std::vector<double>& coordinates)
{
    std::vector<Vec<D>> result(coordinates.size() / D);
    for (std::size_t v = 0; v < result.size(); ++v) result[v] = Eigen::Map<const Vec<D>>(&coordinates[v * D]);
    return result;
}

} // namespace

template<int D>
void Walls<D>::add_fixed(const WallBody& body, const std::vector<double>& coordinates,
                         const std::vector<std::array<int, 4>>& facets)
{
    facets_.add_fixed(body, points<D>(coordinates), split_facets<D>(facets));
    stale_ = true;
    still_reach_ = -1;
}

template<int D>
void Walls<D>::add_driven(const WallBody& body, const std::vector<double>& coordinates,
                          const std::vector<std::array<int, 4>>& facets, RigidMotion<D> motion)
{
    facets_.add_driven(body, points<D>(coordinates), split_facets<D>(facets), std::move(motion));
    stale_ = true;
}

template<int D>
void Walls<D>::set_moving(const WallBody& body, const VertexMotion<D>& motion, const std::vector<WallFacet<D>>& facets)
{
    const int first = facets_.first_of_interface();
    bool same = facets_.size() - first == static_cast<int>(facets.size());
    for (std::size_t f = 0; same && f < facets.size(); ++f) {
        const WallFacet<D>& old = facets_[first + static_cast<int>(f)];
        for (std::size_t c = 0; c < D; ++c) same &= old.vertex[c] == facets[f].vertex[c] + facets_.rigid_vertices();
        same &= old.source == facets[f].source && old.corner == facets[f].corner;
    }
    stale_ = stale_ || !same;
    facets_.set_moving(body, motion, facets);
}

template<int D> void Walls<D>::fill_grids(double reach)
{
    const auto fill = [&](base::BoxGrid<D>& grid, int first, int last) {
        grid.clear();
        for (int f = first; f < last; ++f) grid.add(f, base::box_around<D>(facets_.corners(f)).widened(reach));
        grid.build();
    };
    if (still_reach_ != reach) fill(still_grid_, 0, facets_.still_facets());
    still_reach_ = reach;
    fill(moving_grid_, facets_.still_facets(), facets_.size());
}

template<int D> void Walls<D>::prepare(const Particles<D>& particles, double skin)
{
    const double reach = settings_.support + skin;
    if (stale_ || facets_.size() > facets_.still_facets()) touching_.find(facets_, 0.05 * settings_.spacing);
    fill_grids(reach);
    rows_.clear();
    candidates_.clear();
    for (std::size_t k = 0; k < particles.owned.size(); ++k) {
        const Vec<D>& x = particles.position[static_cast<std::size_t>(particles.owned[k])];
        const int begin = static_cast<int>(candidates_.size());
        visit_near(x, [&](int f) {
            if (base::closest_point(facets_.corners(f), x).squared_distance < reach * reach) candidates_.push_back(f);
        });
        if (static_cast<int>(candidates_.size()) > begin)
            rows_.push_back({k, begin, static_cast<int>(candidates_.size())});
    }
    prepared_at_ = facets_.positions();
    stale_ = false;
}

template<int D> void Walls<D>::renew_touching()
{
    if (facets_.size() > facets_.still_facets()) touching_.find(facets_, 0.05 * settings_.spacing);
}

template<int D> double Walls<D>::largest_displacement() const
{
    if (stale_) return std::numeric_limits<double>::max();
    double largest = 0;
    const auto& now = facets_.positions();
    for (auto v = static_cast<std::size_t>(facets_.still_vertices()); v < now.size(); ++v)
        largest = std::max(largest, (now[v] - prepared_at_[v]).squaredNorm());
    return std::sqrt(largest);
}

template<int D> void Walls<D>::find_contacts(const Particles<D>& particles)
{
    base::ensure(!stale_, "walls are prepared before contacts are looked for");
    contacts_.contacts.clear();
    contacts_.planes.clear();
    contacts_.footprints.clear();
    ContactFinder<D> finder(facets_, touching_, settings_);
    FootprintFinder<D> footprints(facets_, touching_, settings_);
    for (const Row& row : rows_) {
        const int i = particles.owned[row.row];
        const std::span<const int> candidates(candidates_.data() + row.begin,
                                              static_cast<std::size_t>(row.end - row.begin));
        const int first = static_cast<int>(contacts_.planes.size());
        finder.append_planes(particles.position[static_cast<std::size_t>(i)], candidates, contacts_.planes);
        const int last = static_cast<int>(contacts_.planes.size());
        if (last > first) contacts_.contacts.push_back({row.row, i, first, last});
        for (auto plane = contacts_.planes.begin() + first; plane != contacts_.planes.end(); ++plane)
            if (facets_.is_wet(plane->facet)) footprints.append(*plane, contacts_.footprints);
    }
}

template<int D> bool Walls<D>::may_interact(const Vec<D>& x_i, const Vec<D>& x_j) const
{
    constexpr std::size_t most = 8;
    std::array<int, most> crossed;
    std::size_t count = 0;
    bool goes_in = false, comes_out = false, through = false;
    double inside = 0; // length of the way behind a facet [m]
    visit_near(x_i, [&](int f) {
        const double fraction = base::crossing_fraction<D>(facets_.corners(f), x_i, x_j);
        if (fraction < 0) return;
        for (std::size_t c = 0; c < count; ++c)
            through |= facets_.normal(f).dot(facets_.normal(crossed[c])) < cos_opposite;
        if (count < most) crossed[count++] = f;
        const bool leaves = (x_j - x_i).dot(facets_.normal(f)) > 0;
        (leaves ? comes_out : goes_in) = true;
        inside = std::max(inside, (leaves ? fraction : 1 - fraction) * (x_j - x_i).norm());
    });
    return !through && (goes_in == comes_out || inside < 0.3 * settings_.spacing);
}

template<int D> Penetration Walls<D>::penetration() const
{
    Penetration result;
    for (const WallContact& contact : contacts_.contacts) {
        const double distance = contacts_.planes[static_cast<std::size_t>(contact.plane_begin)].distance;
        if (distance >= 0) continue;
        ++result.count;
        result.deepest = std::max(result.deepest, -distance / settings_.spacing);
    }
    return result;
}

template class Walls<2>;
template class Walls<3>;

} // namespace sph

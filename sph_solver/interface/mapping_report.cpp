// SPDX-License-Identifier: MIT
#include "sph_solver/interface/mapping_report.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph {
namespace {

/// A facet as one rank sees it.
struct Seen {
    std::int64_t id;
    double area;
    std::int64_t touched;
};

/// Each facet once, with what any rank knows of it.
std::vector<Seen> united(std::vector<Seen> all)
{
    std::ranges::sort(all, {}, &Seen::id);
    std::vector<Seen> once;
    for (const Seen& facet : all) {
        if (once.empty() || once.back().id != facet.id) once.push_back({facet.id, facet.area, 0});
        once.back().touched |= facet.touched;
    }
    return once;
}

/// Sums over the wall points of this rank.
template<int D> class PointSums {
public:
    PointSums(const Walls<D>& walls, double spacing) : walls_(walls), spacing_(spacing) {}

    /// \param seen facets of the interface, of which the first has the number `first` in the walls' sources
    void add(const MirrorPlane<D>& plane, std::vector<Seen>& seen, std::size_t first)
    {
        const auto& facets = walls_.facets();
        Vec<D> centre = Vec<D>::Zero();
        double sum = 0;
        for (int part = plane.footprint_begin; part < plane.footprint_end; ++part) {
            const auto& [facet, weight] = walls_.contacts().footprints[static_cast<std::size_t>(part)];
            const auto corners = facets.corners(facet);
            for (std::size_t c = 0; c < D; ++c) {
                centre += weight[c] * corners[c];
                sum += weight[c];
            }
            const std::size_t own = static_cast<std::size_t>(facets[facet].source) - first;
            if (own < seen.size()) seen[own].touched = 1; // a footprint may reach over to a neighbour
        }
        ++points;
        constant = std::max(constant, std::abs(sum - 1));
        off_centre = std::max(off_centre, (centre - plane.point).norm() / spacing_);
        const double distance = plane.distance / spacing_;
        nearest = std::min(nearest, distance);
        if (distance > 1) return;
        layer += distance;
        ++layer_points;
    }

    std::int64_t points = 0, layer_points = 0;
    double constant = 0, off_centre = 0, nearest = std::numeric_limits<double>::max(), layer = 0;

private:
    const Walls<D>& walls_;
    double spacing_;
};

} // namespace

template<int D>
MappingReport examine_mapping(const Walls<D>& walls, const coupler::FacetBatch& batch, const InterfacePlace& place,
                              double spacing, const base::Communicator& comm)
{
    const auto& facets = walls.facets();
    std::vector<Seen> seen;
    for (const std::int64_t id : batch.facet_ids) seen.push_back({id, 0, 0});
    const auto number = [&](int f) { return static_cast<std::size_t>(facets[f].source) - place.facet; };
    const auto is_own = [&](int f) { return f >= facets.first_of_interface() && number(f) < seen.size(); };
    for (int f = facets.first_of_interface(); f < facets.size(); ++f)
        if (is_own(f)) seen[number(f)].area += base::area_vector(facets.corners(f)).norm();
    PointSums<D> sums(walls, spacing);
    for (const WallContact& contact : walls.contacts().contacts)
        for (int p = contact.plane_begin; p < contact.plane_end; ++p) {
            const MirrorPlane<D>& plane = walls.contacts().planes[static_cast<std::size_t>(p)];
            if (is_own(plane.facet)) sums.add(plane, seen, place.facet);
        }
    MappingReport report;
    for (const Seen& facet : united(comm.gather_all(seen))) {
        ++report.facets;
        report.touched += facet.touched;
        report.area += facet.area;
    }
    report.points = comm.sum(sums.points);
    report.nearest = report.points > 0 ? comm.min(sums.nearest) : 0;
    const auto layer_points = comm.sum(sums.layer_points);
    const double layer = comm.sum(sums.layer);
    report.layer = layer_points > 0 ? layer / static_cast<double>(layer_points) : 0;
    report.constant_error = comm.max(sums.constant);
    report.centre_distance = comm.max(sums.off_centre);
    return report;
}

std::string describe(const MappingReport& report, const std::string& name, int dimension, double spacing)
{
    const char* unit = dimension == 2 ? "m" : "m2";
    const double mean = report.facets > 0 ? report.area / static_cast<double>(report.facets) : 0;
    const double size = (dimension == 2 ? mean : std::sqrt(mean)) / spacing;
    std::string line = fmt::format("interface '{}': {} facets, {:.4g} {}, {:.2g} dx each", name, report.facets,
                                   report.area, unit, size);
    if (report.points == 0) return line + "; no water touches them yet";
    return line +
           fmt::format("; water touches {} of them, its first layer {:.2f} dx away, its nearest particle {:.2f} dx; "
                       "a uniform motion is met to {:.1g}, a turn to {:.2g} dx a radian",
                       report.touched, report.layer, report.nearest, report.constant_error, report.centre_distance);
}

template MappingReport examine_mapping<2>(const Walls<2>&, const coupler::FacetBatch&, const InterfacePlace&, double,
                                          const base::Communicator&);
template MappingReport examine_mapping<3>(const Walls<3>&, const coupler::FacetBatch&, const InterfacePlace&, double,
                                          const base::Communicator&);

} // namespace sph

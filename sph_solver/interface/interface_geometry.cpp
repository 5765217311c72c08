// SPDX-License-Identifier: MIT
#include "sph_solver/interface/interface_geometry.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/walls/split_facets.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

template<int D> std::vector<Vec<D>> vectors(const std::vector<double>& numbers)
{
    std::vector<Vec<D>> result(numbers.size() / D);
    for (std::size_t v = 0; v < result.size(); ++v) result[v] = Eigen::Map<const Vec<D>>(&numbers[v * D]);
    return result;
}

/// Force on corner c of facet f of the batch.
template<int D> Vec<D> corner_force(const coupler::FacetLoads& loads, std::size_t f, std::size_t c)
{
    Vec<D> force;
    for (int a = 0; a < D; ++a) force[a] = loads.corner_force[(f * 4 + c) * D + static_cast<std::size_t>(a)].value();
    return force;
}

/// Calls visit(facet, corner, node) for every corner that is used.
template<class Visit> void for_each_corner(const coupler::FacetBatch& batch, Visit&& visit)
{
    for (std::size_t f = 0; f < batch.facet_nodes.size(); ++f)
        for (std::size_t c = 0; c < 4; ++c)
            if (batch.facet_nodes[f][c] >= 0) visit(f, c, static_cast<std::size_t>(batch.facet_nodes[f][c]));
}

template<class T> void append(std::vector<T>& to, const std::vector<T>& from)
{
    to.insert(to.end(), from.begin(), from.end());
}

/// `count` items of `width` values each, or none where the array is empty.
template<class T>
std::vector<T> part(const std::vector<T>& all, std::size_t first, std::size_t count, std::size_t width)
{
    if (all.empty()) return {};
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first * width);
    return {begin, begin + static_cast<std::ptrdiff_t>(count * width)};
}

} // namespace

coupler::FacetBatch joined(const std::vector<const coupler::FacetBatch*>& batches)
{
    coupler::FacetBatch all;
    int first_node = 0;
    for (const coupler::FacetBatch* batch : batches) {
        all.dimension = batch->dimension;
        for (auto nodes : batch->facet_nodes) {
            for (int& node : nodes)
                if (node >= 0) node += first_node;
            all.facet_nodes.push_back(nodes);
        }
        append(all.motion.position, batch->motion.position);
        append(all.motion.velocity, batch->motion.velocity);
        append(all.motion.acceleration, batch->motion.acceleration);
        first_node += static_cast<int>(batch->node_ids.size());
    }
    return all;
}

coupler::FacetLoads part_of(const coupler::FacetLoads& all, std::size_t first, std::size_t count, int dimension)
{
    return {part(all.corner_force, first, count, 4 * static_cast<std::size_t>(dimension)),
            part(all.weight, first, count, 1), part(all.weighted_pressure, first, count, 1),
            part(all.full_weight, first, count, 1)};
}

template<int D> void set_interface_motion(Walls<D>& walls, const coupler::FacetBatch& batch)
{
    base::require_input(batch.dimension == D, "the solid's surface has ", batch.dimension, " dimensions, the fluid ",
                        D);
    const VertexMotion<D> motion{vectors<D>(batch.motion.position), vectors<D>(batch.motion.velocity),
                                 vectors<D>(batch.motion.acceleration)};
    walls.set_moving({"interface"}, motion, split_facets<D>(batch.facet_nodes));
}

template<int D> coupler::RegionBox region_of(const Particles<D>& particles, double margin, double step)
{
    base::Box<D> box;
    for (const int i : particles.owned) box.include(particles.position[static_cast<std::size_t>(i)]);
    coupler::RegionBox region;
    if (box.empty()) return region;
    region.low = region.high = {};
    for (int d = 0; d < D; ++d) {
        region.low[static_cast<std::size_t>(d)] = step * std::floor((box.low[d] - margin) / step);
        region.high[static_cast<std::size_t>(d)] = step * std::ceil((box.high[d] + margin) / step);
    }
    return region;
}

template<int D>
std::array<base::ReproducibleSum, 6> resultant(const coupler::FacetLoads& loads, const Walls<D>& walls,
                                               const coupler::FacetBatch& batch, const InterfacePlace& place)
{
    std::array<base::ReproducibleSum, 6> sums;
    if (loads.corner_force.empty()) return sums;
    const std::size_t first = static_cast<std::size_t>(walls.facets().rigid_vertices()) + place.node;
    for_each_corner(batch, [&](std::size_t f, std::size_t c, std::size_t node) {
        std::array<double, 3> x{}, force{};
        for (std::size_t a = 0; a < D; ++a) {
            const base::ReproducibleSum& part = loads.corner_force[((place.facet + f) * 4 + c) * D + a];
            x[a] = walls.facets().positions()[first + node][static_cast<int>(a)];
            force[a] = part.value();
            sums[a] += part;
        }
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3, d = (a + 2) % 3;
            sums[3 + a].add(x[b] * force[d] - x[d] * force[b]);
        }
    });
    return sums;
}

template<int D>
ExchangeWorks exchange_works(const coupler::FacetLoads& loads, const Walls<D>& walls, const InterfacePlace& place,
                             const coupler::FacetBatch& before, const coupler::FacetBatch& after)
{
    ExchangeWorks works;
    if (loads.corner_force.empty()) return works;
    const std::size_t first = static_cast<std::size_t>(walls.facets().rigid_vertices()) + place.node;
    for_each_corner(before, [&](std::size_t f, std::size_t c, std::size_t node) {
        const Vec<D> force = corner_force<D>(loads, place.facet + f, c);
        const auto& ids = after.node_ids;
        const auto found = std::lower_bound(ids.begin(), ids.end(), before.node_ids[node]);
        if (force.isZero(0) || found == ids.end() || *found != before.node_ids[node]) return;
        const auto now = static_cast<std::size_t>(found - ids.begin());
        const Vec<D> position = Eigen::Map<const Vec<D>>(&after.motion.position[now * D]);
        const Vec<D> start = Eigen::Map<const Vec<D>>(&before.motion.position[node * D]);
        works.jump.add(force.dot(position - walls.facets().positions()[first + node]));
        works.path.add(force.dot(position - start));
    });
    return works;
}

template void set_interface_motion<2>(Walls<2>&, const coupler::FacetBatch&);
template void set_interface_motion<3>(Walls<3>&, const coupler::FacetBatch&);
template coupler::RegionBox region_of<2>(const Particles<2>&, double, double);
template coupler::RegionBox region_of<3>(const Particles<3>&, double, double);
template std::array<base::ReproducibleSum, 6> resultant<2>(const coupler::FacetLoads&, const Walls<2>&,
                                                           const coupler::FacetBatch&, const InterfacePlace&);
template std::array<base::ReproducibleSum, 6> resultant<3>(const coupler::FacetLoads&, const Walls<3>&,
                                                           const coupler::FacetBatch&, const InterfacePlace&);
template ExchangeWorks exchange_works<2>(const coupler::FacetLoads&, const Walls<2>&, const InterfacePlace&,
                                         const coupler::FacetBatch&, const coupler::FacetBatch&);
template ExchangeWorks exchange_works<3>(const coupler::FacetLoads&, const Walls<3>&, const InterfacePlace&,
                                         const coupler::FacetBatch&, const coupler::FacetBatch&);

} // namespace sph

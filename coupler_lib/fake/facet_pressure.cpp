// SPDX-License-Identifier: MIT
#include "coupler_lib/fake/facet_pressure.hpp"

#include "coupler_lib/coupling/facet_geometry.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <cmath>

namespace coupler {

void FacetPressure::measure(const FacetBatch& facets, double time, double dt,
                            const std::function<bool(std::int64_t)>& mine)
{
    const auto& [x, v, a] = facets.motion;
    const std::size_t values = x.size(), count = facets.facet_ids.size();
    dt_ = dt;
    start_ = x;
    position_.resize(values);
    velocity_.resize(values);
    predicted_.resize(values);
    for (std::size_t k = 0; k < values; ++k) {
        position_[k] = x[k] + 0.5 * dt * v[k] + 0.125 * dt * dt * a[k];
        velocity_[k] = v[k] + 0.5 * dt * a[k];
        predicted_[k] = x[k] + dt * v[k] + 0.5 * dt * dt * a[k];
    }
    loads_.corner_force.assign(count * 4 * 2, {});
    loads_.weight.assign(count, {});
    loads_.weighted_pressure.assign(count, {});
    loads_.full_weight.assign(count, 0.0);
    work_ = {};
    for (std::size_t facet = 0; facet < count; ++facet)
        if (mine(facets.facet_ids[facet])) add_facet(facets, facet, time + 0.5 * dt);
}

void FacetPressure::add_facet(const FacetBatch& facets, std::size_t facet, double middle)
{
    const auto& nodes = facets.facet_nodes[facet];
    const std::size_t corners[2] = {2 * static_cast<std::size_t>(nodes[0]), 2 * static_cast<std::size_t>(nodes[1])};
    const double *a = &position_[corners[0]], *b = &position_[corners[1]];
    const double area[2] = {b[1] - a[1], -(b[0] - a[0])}; // n L
    const double length = std::hypot(area[0], area[1]);
    double pressure[2];
    for (int end = 0; end < 2; ++end) {
        const double* velocity = &velocity_[corners[end]];
        const double outward = (velocity[0] * area[0] + velocity[1] * area[1]) / length;
        pressure[end] =
            pressure_at(law_, end == 0 ? a[1] : b[1], middle) + (fluid_.radiating ? fluid_.impedance * outward : 0.0);
        base::require(std::isfinite(pressure[end]), base::ExitCode::numerical_failure, "the pressure on wet facet ",
                      facets.facet_ids[facet], " at ", point_text(end == 0 ? a : b, 2),
                      " is not a number: ", pressure[end], " Pa");
    }
    for (std::size_t end = 0; end < 2; ++end)
        for (std::size_t d = 0; d < 2; ++d) {
            const double force = -area[d] * (pressure[end] / 3 + pressure[1 - end] / 6);
            loads_.corner_force[(4 * facet + end) * 2 + d].add(force);
            work_.add(force * velocity_[corners[end] + d] * dt_);
        }
    loads_.weight[facet].add(length);
    loads_.weighted_pressure[facet].add(0.5 * length * (pressure[0] + pressure[1]));
    loads_.full_weight[facet] = length;
}

base::ReproducibleSum FacetPressure::work_from(const std::vector<double>& position, const FacetBatch& corrected) const
{
    base::ReproducibleSum work;
    for (std::size_t facet = 0; facet < corrected.facet_ids.size(); ++facet)
        for (std::size_t end = 0; end < 2; ++end)
            for (std::size_t d = 0; d < 2; ++d) {
                const std::size_t at = 2 * static_cast<std::size_t>(corrected.facet_nodes[facet][end]) + d;
                const double way = corrected.motion.position[at] - position[at];
                work.add(loads_.corner_force[(4 * facet + end) * 2 + d].value() * way);
            }
    return work;
}

std::vector<base::ReproducibleSum> FacetPressure::resultants(const FacetBatch& facets) const
{
    std::vector<base::ReproducibleSum> sums(3);
    for (std::size_t facet = 0; facet < facets.facet_ids.size(); ++facet)
        for (std::size_t end = 0; end < 2; ++end) {
            const double* x = &position_[2 * static_cast<std::size_t>(facets.facet_nodes[facet][end])];
            const auto* force = &loads_.corner_force[(4 * facet + end) * 2];
            sums[0] += force[0];
            sums[1] += force[1];
            sums[2].add(x[0] * force[1].value() - x[1] * force[0].value());
        }
    return sums;
}

} // namespace coupler

// SPDX-License-Identifier: MIT
#include "coupler_lib/fake/piston_surface.hpp"

#include "coupler_lib/coupling/facet_geometry.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <cmath>

namespace coupler {

PistonSurface::PistonSurface(const PistonSurfaceConfig& config, const base::Communicator& comm) : comm_(&comm)
{
    const double dx = config.end[0] - config.start[0], dy = config.end[1] - config.start[1];
    length_ = std::hypot(dx, dy);
    const double size = std::hypot(config.axis[0], config.axis[1]);
    base::require_input(length_ > 0, "[surface] start and end are the same point");
    base::require_input(size > 0, "[surface] axis is zero; it is the direction of positive displacement");
    axis_ = {config.axis[0] / size, config.axis[1] / size};
    normal_ = {dy / length_, -dx / length_};
    centre_ = {config.start[0] + dx / 2, config.start[1] + dy / 2};
    const int first = config.facets * comm.rank() / comm.size(), last = config.facets * (comm.rank() + 1) / comm.size();
    for (int node = first; node <= last && first < last; ++node) {
        const double part = static_cast<double>(node) / config.facets;
        wet_.node_ids.push_back(node);
        wet_.reference.insert(wet_.reference.end(), {config.start[0] + part * dx, config.start[1] + part * dy});
    }
    for (int facet = first; facet < last; ++facet) {
        wet_.facet_ids.push_back(facet);
        wet_.facet_nodes.push_back({facet - first, facet - first + 1, -1, -1});
    }
}

std::array<double, 2> PistonSurface::displacement_vector(double displacement) const
{
    return {displacement * axis_[0], displacement * axis_[1]};
}

SurfaceMotion PistonSurface::motion(double displacement, double velocity, double acceleration) const
{
    SurfaceMotion motion{wet_.reference, {}, {}};
    for (std::size_t k = 0; k < motion.position.size(); ++k) {
        motion.position[k] += displacement * axis_[k % 2];
        motion.velocity.push_back(velocity * axis_[k % 2]);
        motion.acceleration.push_back(acceleration * axis_[k % 2]);
    }
    return motion;
}

/// Over all ranks [N/m].
std::array<double, 2> PistonSurface::total_force(const SurfaceLoad& load) const
{
    std::vector<base::ReproducibleSum> sums(2);
    for (std::size_t k = 0; k < load.force.size(); ++k) sums[k % 2].add(load.force[k]);
    for (std::size_t facet = 0; facet < load.pressure.size(); ++facet) {
        const double thrust = load.pressure[facet] * facet_measure(wet_.facet_nodes[facet], wet_.reference, 2);
        for (std::size_t d = 0; d < 2; ++d) sums[d].add(-thrust * normal_[d]);
    }
    sums = comm_->total(sums);
    return {sums[0].value(), sums[1].value()};
}

double PistonSurface::axial(const SurfaceLoad& load) const
{
    const auto force = total_force(load);
    return (force[0] * axis_[0] + force[1] * axis_[1]) / length_;
}

double PistonSurface::axial(const std::vector<double>& nodal) const
{
    const double mine = nodal.empty() ? -1e300 : nodal[0] * axis_[0] + nodal[1] * axis_[1];
    return comm_->max(mine);
}

void PistonSurface::resultants(const SurfaceLoad& load, double displacement, double axial_load,
                               SolidReport& report) const
{
    auto force = total_force(load);
    const double correction = axial_load * length_ - (force[0] * axis_[0] + force[1] * axis_[1]);
    base::ReproducibleSum moment;
    for (std::size_t k = 0; k < load.force.size(); k += 2) {
        const double x = wet_.reference[k] + displacement * axis_[0],
                     y = wet_.reference[k + 1] + displacement * axis_[1];
        moment.add(x * load.force[k + 1] - y * load.force[k]);
    }
    for (std::size_t facet = 0; facet < load.pressure.size(); ++facet) {
        const double thrust = load.pressure[facet] * facet_measure(wet_.facet_nodes[facet], wet_.reference, 2);
        const auto x = facet_centre(wet_.facet_nodes[facet], wet_.reference, 2);
        moment.add(-thrust *
                   ((x[0] + displacement * axis_[0]) * normal_[1] - (x[1] + displacement * axis_[1]) * normal_[0]));
    }
    report.moment = {0, 0, comm_->total(moment).value() + correction * (centre_[0] * axis_[1] - centre_[1] * axis_[0])};
    report.force = {force[0] + correction * axis_[0], force[1] + correction * axis_[1], 0};
}

} // namespace coupler

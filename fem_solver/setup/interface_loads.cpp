// SPDX-License-Identifier: MIT
#include "fem_solver/setup/interface_loads.hpp"

#include <algorithm>

namespace fem {

InterfaceLoads::InterfaceLoads(const Mesh& mesh, const WetBoundary& boundary, SolidForces& forces,
                               const InterfaceLoadSettings& settings)
    : boundary_(&boundary), settings_(settings)
{
    if (settings.averaged) {
        auto load = std::make_unique<FacetPressure>(mesh, forces.pattern(), boundary.facets());
        pressure_ = load.get();
        forces.set_interface_load(std::move(load));
    } else {
        auto load = std::make_unique<DeadLoad>(Eigen::VectorXd::Zero(forces.dofs()));
        nodal_ = load.get();
        forces.set_interface_load(std::move(load));
    }
    if (settings.impedance_factor > 0) {
        auto load = std::make_unique<ImpedanceLoad>(mesh, forces.pattern(), boundary.facets());
        impedance_ = load.get();
        forces.set_correction(std::move(load));
    }
}

void InterfaceLoads::start(const coupler::SurfaceLoad& load) { set_measured(load); }

void InterfaceLoads::set(const coupler::SurfaceLoad& load, const Motion& motion)
{
    set_measured(load);
    if (impedance_)
        impedance_->set(settings_.impedance_factor * load.impedance, wet_facets(load), motion.displacement,
                        boundary_->spread(load.wall_velocity));
}

void InterfaceLoads::set_measured(const coupler::SurfaceLoad& load)
{
    if (pressure_)
        pressure_->set(load.pressure);
    else
        nodal_->set(boundary_->spread(load.force));
}

/// Facets that the fluid presses on: with a pressure, or with a force on all their nodes.
std::vector<char> InterfaceLoads::wet_facets(const coupler::SurfaceLoad& load) const
{
    const auto& facets = boundary_->facets();
    std::vector<char> wet(facets.size(), 0);
    if (pressure_) {
        for (std::size_t f = 0; f < facets.size(); ++f) wet[f] = load.pressure[f] != 0;
        return wet;
    }
    if (facets.empty()) return wet;
    const Eigen::Index d = std::ssize(load.force) / std::ssize(boundary_->surface_nodes());
    const Eigen::VectorXd& force = nodal_->force();
    for (std::size_t f = 0; f < facets.size(); ++f)
        wet[f] =
            std::ranges::all_of(facets[f], [&](int node) { return node < 0 || !force.segment(node * d, d).isZero(0); });
    return wet;
}

} // namespace fem

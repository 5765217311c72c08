// SPDX-License-Identifier: MIT
#include "fem_solver/output/probes.hpp"

#include <map>

namespace fem {
namespace {

struct Quantity {
    const char* symbol;
    const char* unit; // in 2D
    Eigen::VectorXd Motion::*field;
};

const std::map<std::string, Quantity> quantities{{"displacement", {"u", "[m]", &Motion::displacement}},
                                                 {"velocity", {"v", "[m/s]", &Motion::velocity}},
                                                 {"acceleration", {"a", "[m/s^2]", &Motion::acceleration}},
                                                 {"load", {"f", "[N/m]", nullptr}}};

} // namespace

Probes::Probes(const Mesh& mesh, const std::vector<ProbeConfig>& probes) : mesh_(&mesh)
{
    for (const ProbeConfig& probe : probes) {
        const int nearest = mesh.nearest_node(probe.position);
        const bool own = nearest >= 0 && nearest < mesh.own_nodes();
        for (const std::string& name : probe.quantities) {
            const Quantity& quantity = quantities.at(name);
            for (int k = 0; k < mesh.dimension; ++k) {
                const char* unit = !quantity.field && mesh.dimension == 3 ? "[N]" : quantity.unit;
                columns_.push_back(probe.name + "." + quantity.symbol + "xyz"[k] + unit);
                entries_.push_back({quantity.field, own ? nearest * mesh.dimension + k : -1});
            }
        }
    }
}

std::vector<double> Probes::values(const Motion& motion, const Eigen::VectorXd& load) const
{
    std::vector<double> result;
    for (const auto& [field, dof] : entries_) result.push_back(dof < 0 ? 0 : (field ? motion.*field : load)[dof]);
    return mesh_->team().sum(std::move(result));
}

} // namespace fem

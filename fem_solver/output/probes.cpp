// SPDX-License-Identifier: MIT
#include "fem_solver/output/probes.hpp"

#include <map>

namespace fem {
namespace {

struct Quantity {
    const char* symbol;
    const char* unit;
    Eigen::VectorXd Motion::*field;
};

const std::map<std::string, Quantity> quantities{{"displacement", {"u", "[m]", &Motion::displacement}},
                                                 {"velocity", {"v", "[m/s]", &Motion::velocity}},
                                                 {"acceleration", {"a", "[m/s^2]", &Motion::acceleration}}};

} // namespace

Probes::Probes(const Mesh& mesh, const std::vector<ProbeConfig>& probes)
{
    for (const ProbeConfig& probe : probes) {
        const int node = mesh.nearest_node(probe.position);
        for (const std::string& name : probe.quantities) {
            const Quantity& quantity = quantities.at(name);
            for (int k = 0; k < mesh.dimension; ++k) {
                columns_.push_back(probe.name + "." + quantity.symbol + "xyz"[k] + quantity.unit);
                entries_.push_back({quantity.field, static_cast<Eigen::Index>(node) * mesh.dimension + k});
            }
        }
    }
}

std::vector<double> Probes::values(const Motion& motion) const
{
    std::vector<double> result;
    for (const Entry& entry : entries_) result.push_back((motion.*entry.field)[entry.dof]);
    return result;
}

} // namespace fem

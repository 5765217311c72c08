// SPDX-License-Identifier: MIT
#include "fem_solver/setup/make_mesh.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/mesh/block_mesh.hpp"
#include "fem_solver/mesh/med_mesh.hpp"
#include "fem_solver/mesh/partition.hpp"

namespace fem {
namespace {

ElementType element_type(const std::string& name)
{
    for (const auto& [type, known] : element_names)
        if (known == name) return type;
    throw base::Error(base::ExitCode::bad_input, "unknown element \"" + name + "\"");
}

Mesh whole_mesh(const MeshConfig& config, int dimension)
{
    if (config.kind == "med") return read_med_mesh({config.file, config.name, dimension, config.scale});
    return make_block(
        {element_type(config.element), config.low, config.high, {config.cells.begin(), config.cells.end()}});
}

/// Groups of faces that carry the fluid's load or contact.
std::vector<std::string> busy_groups(const SolidConfig& config)
{
    std::vector<std::string> groups = config.interface.groups;
    for (const ContactConfig& contact : config.contacts) groups.push_back(contact.group);
    return groups;
}

} // namespace

Mesh make_mesh(const SolidConfig& config, const Team& team)
{
    Mesh whole = whole_mesh(config.mesh, config.model.dimension);
    if (!team.comm()) return whole;
    const auto elements = partition_elements(whole, element_work(whole, busy_groups(config)), team.size());
    return cut_mesh(whole, elements, partition_nodes(whole, elements, team.size()), *team.comm());
}

} // namespace fem

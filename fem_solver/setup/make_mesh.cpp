// SPDX-License-Identifier: MIT
#include "fem_solver/setup/make_mesh.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/mesh/block_mesh.hpp"
#include "fem_solver/mesh/med_mesh.hpp"

namespace fem {
namespace {

ElementType element_type(const std::string& name)
{
    for (const auto& [type, known] : element_names)
        if (known == name) return type;
    throw base::Error(base::ExitCode::bad_input, "unknown element \"" + name + "\"");
}

} // namespace

Mesh make_mesh(const MeshConfig& config, int dimension)
{
    if (config.kind == "med") return read_med_mesh({config.file, config.name, dimension, config.scale});
    return make_block(
        {element_type(config.element), config.low, config.high, {config.cells.begin(), config.cells.end()}});
}

} // namespace fem

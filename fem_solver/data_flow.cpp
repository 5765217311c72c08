// SPDX-License-Identifier: MIT
#include "fem_solver/data_flow.hpp"

#include "fem_solver/material/point_law.hpp"

#include <algorithm>
#include <cmath>

namespace fem {
namespace {

/// Speed of compression waves at small strain, c_s = sqrt(A_1111 / rho) with A = dP/dF at F = 1 [m/s].
template<int D> double wave_speed(const SolidConfig& config)
{
    const auto law = make_point_law<D>(make_material(config.material));
    return std::sqrt(law->tangent(Tensor<D>::Identity())(0, 0) / config.material.density);
}

/// Faces of a group over all ranks.
int count_faces(const Mesh& mesh, const std::string& group)
{
    const auto own = std::ranges::count_if(mesh.faces(group),
                                           [&](const MeshFace& face) { return face.element < mesh.own_elements(); });
    return static_cast<int>(mesh.team().sum(std::int64_t{own}));
}

} // namespace

coupler::DataFlow data_flow(const SolidConfig& config, const SolidModel& model, const coupler::Session& session)
{
    coupler::DataFlow flow;
    flow.dimension = model.mesh().dimension;
    flow.fields =
        coupler::interface_fields(flow.dimension, session.coupling().interface_of(session.role()), session.role());
    for (const auto& group : config.interface.groups) flow.groups.emplace_back(group, count_faces(model.mesh(), group));
    flow.end = config.time.end;
    flow.dt = config.time.dt;
    flow.density = config.material.density;
    flow.wave_speed = flow.dimension == 2 ? wave_speed<2>(config) : wave_speed<3>(config);
    flow.thickness = bounding_box(model.mesh()).shortest_side();
    return flow;
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "coupler_lib/c_api/handles.hpp"

using namespace coupler;

namespace coupler::c_api {
namespace {

WetSurface surface_of(int dimension, int64_t nodes, const int64_t* node_ids, const double* reference, int64_t facets,
                      const int64_t* facet_ids, const int32_t* facet_nodes)
{
    WetSurface surface;
    surface.dimension = dimension;
    surface.node_ids.assign(node_ids, node_ids + nodes);
    surface.reference.assign(reference, reference + nodes * dimension);
    surface.facet_ids.assign(facet_ids, facet_ids + facets);
    for (int64_t f = 0; f < facets; ++f)
        surface.facet_nodes.push_back(
            {facet_nodes[4 * f], facet_nodes[4 * f + 1], facet_nodes[4 * f + 2], facet_nodes[4 * f + 3]});
    return surface;
}

const double* data_or_null(const std::vector<double>& values) { return values.empty() ? nullptr : values.data(); }

} // namespace

} // namespace coupler::c_api

rivage_solid::rivage_solid(rivage_participant& of, WetSurface surface)
    : exchange(of.member, of.config.interface_of(of.member.role()).settings(of.member.role()), surface),
      filter(of.config.scheme.acceleration == "nodal" ? 0 : of.config.scheme.acceleration_steps),
      prediction(of.config.scheme.load_prediction()),
      values(surface.reference.size())
{}

int rivage_solid_open(rivage_participant* participant, int dimension, int64_t nodes, const int64_t* node_ids,
                      const double* reference, int64_t facets, const int64_t* facet_ids, const int32_t* facet_nodes,
                      rivage_solid** solid)
{
    return c_api::guarded([&] {
        *solid = new rivage_solid(
            *participant, c_api::surface_of(dimension, nodes, node_ids, reference, facets, facet_ids, facet_nodes));
    });
}

int rivage_solid_receive(rivage_solid* solid, rivage_window* window)
{
    return c_api::guarded([&] {
        const Window w = solid->window = solid->exchange.receive(solid->load, solid->fluid);
        *window = {w.step, w.time, w.dt, w.last, w.stop_requested};
    });
}

const double* rivage_solid_force(const rivage_solid* solid) { return c_api::data_or_null(solid->load.force); }
const double* rivage_solid_pressure(const rivage_solid* solid) { return c_api::data_or_null(solid->load.pressure); }
const double* rivage_solid_wall_velocity(const rivage_solid* solid) { return solid->load.wall_velocity.data(); }
double rivage_solid_impedance(const rivage_solid* solid) { return solid->load.impedance; }

int rivage_solid_fluid_report(const rivage_solid* solid, rivage_fluid_report* report)
{
    *report = c_api::to_c(solid->fluid);
    return c_api::remember(RIVAGE_OK, "");
}

int rivage_solid_predict(rivage_solid* solid, const double* velocity, double dt)
{
    return c_api::guarded([&] { solid->prediction->apply(solid->load, {velocity, velocity + solid->values}, dt); });
}

int rivage_solid_send(rivage_solid* solid, const double* position, const double* velocity, const double* acceleration,
                      const rivage_solid_report* report)
{
    return c_api::guarded([&] {
        const auto all = [&](const double* values) { return std::vector<double>(values, values + solid->values); };
        SurfaceMotion motion{all(position), all(velocity), all(acceleration)};
        solid->filter.apply(solid->window.time, motion);
        SolidReport mine = c_api::from_c(*report);
        mine.wait = solid->exchange.wait_seconds();
        solid->exchange.send(motion, mine);
    });
}

int rivage_solid_close(rivage_solid* solid)
{
    return c_api::guarded([&] { delete solid; });
}

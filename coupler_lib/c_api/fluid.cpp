// SPDX-License-Identifier: MIT
#include "coupler_lib/c_api/handles.hpp"

#include <filesystem>

using namespace coupler;

namespace coupler::c_api {
namespace {

std::vector<base::ReproducibleSum> sums_of(const double* values, std::size_t count)
{
    std::vector<base::ReproducibleSum> sums(values ? count : 0);
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k].add(values[k]);
    return sums;
}

RegionBox box_of(const double* low, const double* high)
{
    return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

InterfaceConfig interface_with(const rivage_participant& of, const char* partner)
{
    if (!partner) return of.config.interface_of(of.member.role());
    for (const InterfaceConfig& one : of.config.interfaces_of(of.member.role()))
        if (one.solid == partner) return one;
    throw base::Error(base::ExitCode::bad_input,
                      base::text("'", of.member.role(), "' has no interface with '", partner, "' in coupling.toml"));
}

InterfaceSettings interface_settings(const rivage_participant& of, const InterfaceConfig& interface, double impedance,
                                     double limit)
{
    InterfaceSettings settings = interface.settings(of.member.role());
    settings.impedance = impedance;
    settings.pressure_limit = limit;
    return settings;
}

} // namespace

} // namespace coupler::c_api

rivage_fluid::rivage_fluid(rivage_participant& of, const InterfaceConfig& interface, int dimension, double impedance,
                           double pressure_limit, const char* output_dir)
    : exchange(of.member, c_api::interface_settings(of, interface, impedance, pressure_limit), dimension)
{
    if (!output_dir || !of.member.comm().is_root()) return;
    std::error_code error;
    std::filesystem::create_directories(std::filesystem::path(output_dir) / "coupling", error);
    base::require_input(!error, "cannot make the output folder '", output_dir, "': ", error.message());
    const bool only_one = of.config.interfaces.size() == 1;
    record.emplace(interface_path(output_dir, interface.solid, only_one), dimension);
    if (only_one) energies.emplace(output_dir, dimension);
}

int rivage_fluid_open(rivage_participant* participant, const char* partner, int dimension, double impedance,
                      double pressure_limit, const char* output_dir, rivage_fluid** fluid)
{
    return c_api::guarded([&] {
        *fluid = new rivage_fluid(*participant, c_api::interface_with(*participant, partner), dimension, impedance,
                                  pressure_limit, output_dir);
    });
}

int rivage_fluid_send(rivage_fluid* fluid, const rivage_window* window, const double* low, const double* high,
                      const double* corner_force, const double* weight, const double* weighted_pressure,
                      const double* full_weight, const rivage_fluid_report* report)
{
    return c_api::guarded([&] {
        const std::size_t facets = fluid->batch->facet_ids.size();
        const auto corners = 4 * facets * static_cast<std::size_t>(fluid->batch->dimension);
        FacetLoads loads{c_api::sums_of(corner_force, corners),
                         c_api::sums_of(weight, facets),
                         c_api::sums_of(weighted_pressure, facets),
                         {}};
        if (full_weight) loads.full_weight.assign(full_weight, full_weight + facets);
        fluid->window = {window->step, window->time, window->dt, window->last != 0, window->stop_requested != 0};
        fluid->report = c_api::from_c(*report);
        fluid->report.wait = fluid->exchange.wait_seconds();
        fluid->exchange.send(fluid->window, c_api::box_of(low, high), loads, *fluid->batch, fluid->report);
    });
}

int rivage_fluid_receive(rivage_fluid* fluid, rivage_solid_report* report)
{
    return c_api::guarded([&] {
        SolidReport solid;
        fluid->batch = &fluid->exchange.receive(solid);
        *report = c_api::to_c(solid);
        if (!fluid->record || fluid->window.step < 0) return;
        fluid->record->add(fluid->window, fluid->report, solid);
        fluid->record->write();
        if (!fluid->energies) return;
        fluid->energies->add(fluid->window.time, fluid->report, {solid});
        fluid->energies->write();
    });
}

int64_t rivage_fluid_nodes(const rivage_fluid* fluid) { return std::ssize(fluid->batch->node_ids); }
int64_t rivage_fluid_facets(const rivage_fluid* fluid) { return std::ssize(fluid->batch->facet_ids); }
const int64_t* rivage_fluid_node_ids(const rivage_fluid* fluid) { return fluid->batch->node_ids.data(); }
const int64_t* rivage_fluid_facet_ids(const rivage_fluid* fluid) { return fluid->batch->facet_ids.data(); }
const int32_t* rivage_fluid_facet_nodes(const rivage_fluid* fluid)
{
    return fluid->batch->facet_nodes.empty() ? nullptr : fluid->batch->facet_nodes.front().data();
}
const double* rivage_fluid_position(const rivage_fluid* fluid) { return fluid->batch->motion.position.data(); }
const double* rivage_fluid_velocity(const rivage_fluid* fluid) { return fluid->batch->motion.velocity.data(); }
const double* rivage_fluid_acceleration(const rivage_fluid* fluid) { return fluid->batch->motion.acceleration.data(); }
int rivage_fluid_stop_agreed(const rivage_fluid* fluid) { return fluid->exchange.stop_agreed(); }

int rivage_fluid_close(rivage_fluid* fluid)
{
    return c_api::guarded([&] { delete fluid; });
}

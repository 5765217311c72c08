// SPDX-License-Identifier: MIT
#include "coupler_lib/session/data_flow_check.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace coupler {
namespace {

constexpr double high_beta = 0.5;

/// The other side's use of a field: produced where this one consumes, or the other way round.
const FieldUse* counterpart(const FieldUse& field, const DataFlow& one, const DataFlow& other)
{
    for (const auto& candidate : other.fields)
        if (candidate.name == field.name && candidate.produced != field.produced && candidate.partner == one.role)
            return &candidate;
    return nullptr;
}

void compare_fields(const DataFlow& one, const DataFlow& other, FlowReport& report)
{
    for (const auto& field : one.fields) {
        if (field.partner != other.role) continue;
        const FieldUse* found = counterpart(field, one, other);
        if (!found)
            report.problems.push_back(fmt::format("{} {} '{}' [{}], but {} does not {} it", one.role,
                                                  field.produced ? "sends" : "needs", field.name, field.unit,
                                                  other.role, field.produced ? "take" : "send"));
        else if (found->unit != field.unit && field.produced)
            report.problems.push_back(fmt::format("{} sends '{}' in {}, but {} takes it in {}", one.role, field.name,
                                                  field.unit, other.role, found->unit));
        else if (field.produced)
            report.facts.push_back(fmt::format("{} -> {}: {} [{}]", one.role, other.role, field.name, field.unit));
    }
}

void compare_dimensions(const DataFlow& fluid, const DataFlow& solid, FlowReport& report)
{
    if (fluid.dimension != solid.dimension)
        report.problems.push_back(
            fmt::format("{} is {}D, {} is {}D", fluid.role, fluid.dimension, solid.role, solid.dimension));
}

void list_groups(const DataFlow& side, FlowReport& report)
{
    for (const auto& [name, facets] : side.groups) {
        if (facets > 0)
            report.facts.push_back(fmt::format("{} brings the surface '{}': {} facets", side.role, name, facets));
        else
            report.problems.push_back(fmt::format("{}: the wet surface '{}' has no facet", side.role, name));
    }
}

void compare_times(const CouplingConfig& config, const DataFlow& side, FlowReport& report)
{
    if (side.end > 0 && std::abs(side.end - config.time.end) > 1e-12 * config.time.end)
        report.advice.push_back(
            fmt::format("the end time in the file of {}, {} s, is overruled by {} s of the shared file", side.role,
                        side.end, config.time.end));
}

void compare_steps(const CouplingConfig& config, const DataFlow& fluid, const DataFlow& solid, FlowReport& report)
{
    if (fluid.dt > 0)
        report.facts.push_back(fmt::format("{} sets the step, dt = {:.4g} s at the start: about {:.0f} steps to {} s",
                                           fluid.role, fluid.dt, config.time.end / fluid.dt, config.time.end));
    if (solid.dt > 0)
        report.advice.push_back(
            fmt::format("the step in the file of {}, {:.4g} s, is not used in a coupled run: {} sets it", solid.role,
                        solid.dt, fluid.role));
}

void judge_stability(const CouplingConfig& config, const DataFlow& fluid, const DataFlow& solid, FlowReport& report)
{
    DataFlow window = fluid; // from one exchange to the next
    window.dt *= config.scheme.solid_every;
    const double beta = stability_number(window, solid);
    if (beta <= 0) return;
    report.facts.push_back(
        fmt::format("stability number of {} and {}: rho c dt / m = {:.3g}", fluid.role, solid.role, beta));
    if (beta <= high_beta) return;
    report.advice.push_back(fmt::format(
        "rho c dt / m = {:.3g} is above {}: {}judge the run by the interface work mismatch, not by the "
        "deflection, and try a smaller time step if it grows",
        beta, high_beta, config.scheme.scheme == "parallel" ? "use [coupling] scheme = \"parallel_impedance\", " : ""));
}

} // namespace

double stability_number(const DataFlow& fluid, const DataFlow& solid)
{
    const double depth = std::min(solid.thickness, solid.wave_speed * fluid.dt);
    const double mass = solid.density * depth;
    return mass > 0 ? fluid.impedance * fluid.dt / mass : 0;
}

FlowReport check_data_flow(const CouplingConfig& config, const std::vector<DataFlow>& sides)
{
    FlowReport report;
    for (const auto& side : sides) {
        compare_times(config, side, report);
        list_groups(side, report);
    }
    for (const InterfaceConfig& interface : config.interfaces) {
        const auto fluid = std::ranges::find(sides, interface.fluid, &DataFlow::role);
        const auto solid = std::ranges::find(sides, interface.solid, &DataFlow::role);
        if (fluid == sides.end() || solid == sides.end()) continue;
        compare_dimensions(*fluid, *solid, report);
        compare_fields(*fluid, *solid, report);
        compare_fields(*solid, *fluid, report);
        compare_steps(config, *fluid, *solid, report);
        judge_stability(config, *fluid, *solid, report);
    }
    return report;
}

} // namespace coupler

// SPDX-License-Identifier: MIT
#include "coupler_lib/c_api/handles.hpp"

#include <algorithm>
#include <utility>

namespace coupler::c_api {
namespace {

template<class Ours, class Theirs> using Field = std::pair<double Ours::*, double Theirs::*>;

constexpr Field<FluidReport, rivage_fluid_report> fluid_fields[] = {
    {&FluidReport::kinetic, &rivage_fluid_report::kinetic},
    {&FluidReport::potential, &rivage_fluid_report::potential},
    {&FluidReport::internal, &rivage_fluid_report::internal},
    {&FluidReport::external_work, &rivage_fluid_report::external_work},
    {&FluidReport::outflow, &rivage_fluid_report::outflow},
    {&FluidReport::dissipated, &rivage_fluid_report::dissipated},
    {&FluidReport::work_on_solid, &rivage_fluid_report::work_on_solid},
    {&FluidReport::path_work, &rivage_fluid_report::path_work},
    {&FluidReport::jump_work, &rivage_fluid_report::jump_work},
    {&FluidReport::wait, &rivage_fluid_report::wait}};

constexpr Field<SolidReport, rivage_solid_report> solid_fields[] = {
    {&SolidReport::work, &rivage_solid_report::work},
    {&SolidReport::displacement_max, &rivage_solid_report::displacement_max},
    {&SolidReport::kinetic, &rivage_solid_report::kinetic},
    {&SolidReport::strain, &rivage_solid_report::strain},
    {&SolidReport::potential, &rivage_solid_report::potential},
    {&SolidReport::external_work, &rivage_solid_report::external_work},
    {&SolidReport::dissipated, &rivage_solid_report::dissipated},
    {&SolidReport::wait, &rivage_solid_report::wait}};

template<class Ours, class Theirs, std::size_t N>
Ours taken(const Theirs& theirs, const Field<Ours, Theirs> (&fields)[N])
{
    Ours ours;
    for (const auto& [own, other] : fields) ours.*own = theirs.*other;
    std::copy_n(theirs.force, 3, ours.force.begin());
    std::copy_n(theirs.moment, 3, ours.moment.begin());
    return ours;
}

template<class Ours, class Theirs, std::size_t N> Theirs given(const Ours& ours, const Field<Ours, Theirs> (&fields)[N])
{
    Theirs theirs{};
    for (const auto& [own, other] : fields) theirs.*other = ours.*own;
    std::copy_n(ours.force.begin(), 3, theirs.force);
    std::copy_n(ours.moment.begin(), 3, theirs.moment);
    return theirs;
}

} // namespace

FluidReport from_c(const rivage_fluid_report& report) { return taken(report, fluid_fields); }
SolidReport from_c(const rivage_solid_report& report) { return taken(report, solid_fields); }
rivage_fluid_report to_c(const FluidReport& report) { return given(report, fluid_fields); }
rivage_solid_report to_c(const SolidReport& report) { return given(report, solid_fields); }

} // namespace coupler::c_api

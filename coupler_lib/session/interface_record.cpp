// SPDX-License-Identifier: MIT
#include "coupler_lib/session/interface_record.hpp"

namespace coupler {
namespace {

std::vector<std::string> energy_columns(int dimension)
{
    const std::string unit = dimension == 2 ? "[J/m]" : "[J]";
    std::vector<std::string> columns{"t[s]"};
    for (const char* name : {"fluid", "solid", "total", "external_work_fluid", "external_work_solid", "outflow", "dissipation", "drift"})
        columns.push_back(name + unit);
    return columns;
}

}  // namespace

InterfaceRecord::InterfaceRecord(const std::string& output_dir, int dimension)
    : audit_(dimension), interface_(output_dir + "/coupling/interface.csv", audit_.columns()),
      energy_(output_dir + "/energy_total.csv", energy_columns(dimension))
{
}

void InterfaceRecord::add(const Window& window, const FluidReport& fluid, const SolidReport& solid)
{
    audit_.record(window, fluid, solid);
    const double in_fluid = fluid.kinetic + fluid.potential + fluid.internal;
    const double in_solid = solid.kinetic + solid.strain + solid.potential;
    const double balance = in_fluid + in_solid + fluid.outflow - fluid.external_work - solid.external_work;
    if (!started_) balance_start_ = balance;
    started_ = true;
    drift_ = balance - balance_start_;
    energies_ = {window.time, in_fluid, in_solid, in_fluid + in_solid, fluid.external_work, solid.external_work, fluid.outflow,
                 fluid.dissipated + solid.dissipated, drift_};
}

void InterfaceRecord::write()
{
    interface_.row(audit_.row());
    energy_.row(energies_);
    interface_.flush();
    energy_.flush();
}

}  // namespace coupler

// SPDX-License-Identifier: MIT
#include "coupler_lib/session/energy_record.hpp"

namespace coupler {
namespace {

std::vector<std::string> columns(int dimension)
{
    const std::string unit = dimension == 2 ? "[J/m]" : "[J]";
    std::vector<std::string> names{"t[s]"};
    for (const char* name :
         {"fluid", "solid", "total", "external_work_fluid", "external_work_solid", "outflow", "dissipation", "drift"})
        names.push_back(name + unit);
    return names;
}

} // namespace

EnergyRecord::EnergyRecord(const std::string& output_dir, int dimension)
    : table_(output_dir + "/energy_total.csv", columns(dimension))
{}

void EnergyRecord::add(double time, const FluidEnergies& fluid, const std::vector<SolidReport>& solids)
{
    const double in_fluid = fluid.kinetic + fluid.potential + fluid.internal;
    double in_solids = 0, external = 0, dissipated = fluid.dissipated;
    for (const SolidReport& solid : solids) {
        in_solids += solid.kinetic + solid.strain + solid.potential;
        external += solid.external_work;
        dissipated += solid.dissipated;
    }
    const double balance = in_fluid + in_solids + fluid.outflow - fluid.external_work - external;
    if (!started_) start_ = balance;
    started_ = true;
    drift_ = balance - start_;
    row_ = {time,          in_fluid,   in_solids, in_fluid + in_solids, fluid.external_work, external,
            fluid.outflow, dissipated, drift_};
}

void EnergyRecord::write()
{
    table_.row(row_);
    table_.flush();
}

} // namespace coupler

// SPDX-License-Identifier: MIT
#include "coupler_lib/session/interface_record.hpp"

namespace coupler {
namespace {

const std::vector<std::string> energy_columns = {
    "t[s]",       "fluid[J]",       "solid[J]", "total[J]",        "external_work_fluid[J]", "external_work_solid[J]",
    "outflow[J]", "dissipation[J]", "drift[J]"};

}  // namespace

InterfaceRecord::InterfaceRecord(const std::string& output_dir)
    : interface_(output_dir + "/coupling/interface.csv", InterfaceAudit::columns()),
      energy_(output_dir + "/energy_total.csv", energy_columns)
{
}

void InterfaceRecord::write(const Window& window, const FluidReport& fluid, const SolidReport& solid)
{
    interface_.row(audit_.row());
    const double in_fluid = fluid.kinetic + fluid.potential + fluid.internal;
    const double in_solid = solid.kinetic + solid.strain + solid.potential;
    const double balance = in_fluid + in_solid + fluid.outflow - fluid.external_work - solid.external_work;
    if (!started_) balance_start_ = balance;
    started_ = true;
    drift_ = balance - balance_start_;
    energy_.row({window.time, in_fluid, in_solid, in_fluid + in_solid, fluid.external_work, solid.external_work, fluid.outflow,
                 fluid.dissipated + solid.dissipated, drift_});
    interface_.flush();
    energy_.flush();
}

}  // namespace coupler

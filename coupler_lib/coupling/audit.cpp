// SPDX-License-Identifier: MIT
#include "coupler_lib/coupling/audit.hpp"

#include <algorithm>
#include <cmath>

namespace coupler {

void InterfaceAudit::record(const Window& window, const FluidReport& fluid, const SolidReport& solid)
{
    window_ = window;
    fluid_ = fluid;
    solid_ = solid;
    work_on_fluid_ = -(fluid.work_on_solid + fluid.jump_work);
    work_on_solid_ = solid.work;
    peak_work_ = std::max({peak_work_, std::abs(work_on_fluid_), std::abs(work_on_solid_)});
    const double gap = std::abs(work_on_fluid_ + work_on_solid_);
    worst_gap_ = std::max(worst_gap_, gap);
    mismatch_ = peak_work_ > 0 ? gap / peak_work_ : 0;
}

double InterfaceAudit::worst_mismatch() const { return peak_work_ > 0 ? worst_gap_ / peak_work_ : 0; }

std::vector<std::string> InterfaceAudit::columns() const
{
    const std::string newton = dimension_ == 2 ? "[N/m]" : "[N]";
    const std::string joule = dimension_ == 2 ? "[J/m]" : "[J]";
    const std::string moment = dimension_ == 2 ? "[N]" : "[N m]";
    std::vector<std::string> names{"t[s]", "dt[s]", "displacement_max[m]"};
    const std::vector<std::string> axes =
        dimension_ == 2 ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"x", "y", "z"};
    const std::vector<std::string> turns = dimension_ == 2 ? std::vector<std::string>{"z"} : axes;
    for (const char* side : {"sent_", "received_"}) {
        for (const auto& axis : axes) names.push_back("force_" + std::string(side) + axis + newton);
        for (const auto& turn : turns) names.push_back("moment_" + std::string(side) + turn + moment);
    }
    names.insert(names.end(), {"work_on_fluid" + joule, "work_on_solid" + joule, "jump_work" + joule,
                               "lag_work" + joule, "mismatch[-]", "wait_fluid[s]", "wait_solid[s]"});
    return names;
}

std::vector<double> InterfaceAudit::row() const
{
    std::vector<double> values{window_.time, window_.dt, solid_.displacement_max};
    const auto axes = static_cast<std::ptrdiff_t>(dimension_);
    for (const bool sent : {true, false}) {
        const auto& force = sent ? fluid_.force : solid_.force;
        const auto& moment = sent ? fluid_.moment : solid_.moment;
        values.insert(values.end(), force.begin(), force.begin() + axes);
        values.insert(values.end(), dimension_ == 2 ? moment.end() - 1 : moment.begin(), moment.end());
    }
    values.insert(values.end(), {work_on_fluid_, work_on_solid_, fluid_.jump_work, work_on_solid_ - fluid_.path_work,
                                 mismatch_, fluid_.wait, solid_.wait});
    return values;
}

} // namespace coupler

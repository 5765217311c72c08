// SPDX-License-Identifier: MIT
#include "fem_solver/output/energy_table.hpp"

namespace fem {
namespace {

std::vector<std::string> header(int dimension)
{
    std::vector<std::string> columns{"t[s]", "dt[s]"};
    for (const char* name :
         {"kinetic", "strain", "potential", "work_interface", "work_supports", "work_loads", "contact", "friction",
          "numerical_dissipation", "balance_error", "damping", "work_correction"})
        columns.push_back(std::string(name) + (dimension == 2 ? "[J/m]" : "[J]"));
    return columns;
}

} // namespace

EnergyTable::EnergyTable(const std::string& folder, int dimension) : file_(folder + "/energy.csv", header(dimension)) {}

void EnergyTable::write(double time, double dt, const SolidEnergies& e)
{
    file_.row({time, dt, e.kinetic, e.strain, e.potential, e.work_interface, e.work_supports, e.work_loads, 0, 0,
               e.numerical_dissipation, e.balance_error, e.damping, e.work_correction});
    file_.flush();
}

} // namespace fem

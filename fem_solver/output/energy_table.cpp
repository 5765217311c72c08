// SPDX-License-Identifier: MIT
#include "fem_solver/output/energy_table.hpp"

namespace fem {
namespace {

std::vector<std::string> header(int dimension, const std::vector<std::string>& loads)
{
    std::vector<std::string> columns{"t[s]", "dt[s]"};
    for (const char* name :
         {"kinetic", "strain", "potential", "work_interface", "work_supports", "work_loads", "contact", "friction",
          "numerical_dissipation", "balance_error", "damping", "work_correction"})
        columns.push_back(std::string(name) + (dimension == 2 ? "[J/m]" : "[J]"));
    for (const std::string& name : loads) columns.push_back("work_load." + name + (dimension == 2 ? "[J/m]" : "[J]"));
    return columns;
}

} // namespace

EnergyTable::EnergyTable(const std::string& folder, int dimension, const std::vector<std::string>& loads)
    : loads_(loads.size()), file_(folder + "/energy.csv", header(dimension, loads))
{}

void EnergyTable::write(double time, double dt, const SolidEnergies& e)
{
    std::vector<double> row{time,
                            dt,
                            e.kinetic,
                            e.strain,
                            e.potential,
                            e.work_interface,
                            e.work_supports,
                            e.work_loads,
                            0,
                            0,
                            e.numerical_dissipation,
                            e.balance_error,
                            e.damping,
                            e.work_correction};
    row.resize(row.size() + loads_, 0.0);
    std::copy(e.work_of_load.begin(), e.work_of_load.end(), row.end() - static_cast<std::ptrdiff_t>(loads_));
    file_.row(row);
    file_.flush();
}

} // namespace fem

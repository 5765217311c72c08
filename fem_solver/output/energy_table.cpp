// SPDX-License-Identifier: MIT
#include "fem_solver/output/energy_table.hpp"

namespace fem {
namespace {

std::vector<std::string> energy_columns(int dimension, const std::vector<std::string>& loads,
                                        const std::vector<std::string>& supports)
{
    std::vector<std::string> columns{"t[s]", "dt[s]"};
    for (const char* name :
         {"kinetic", "strain", "potential", "work_interface", "work_supports", "work_loads", "contact", "friction",
          "numerical_dissipation", "balance_error", "damping", "work_correction", "material"})
        columns.push_back(std::string(name) + (dimension == 2 ? "[J/m]" : "[J]"));
    const char* unit = dimension == 2 ? "[J/m]" : "[J]";
    for (const std::string& name : loads) columns.push_back("work_load." + name + unit);
    for (const std::string& name : supports) columns.push_back("work_support." + name + unit);
    return columns;
}

} // namespace

EnergyTable::EnergyTable(const std::string& folder, int dimension, const std::vector<std::string>& loads,
                         const std::vector<std::string>& supports)
    : loads_(loads.size()),
      supports_(supports.size()),
      file_(folder + "/energy.csv", energy_columns(dimension, loads, supports))
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
                            e.contact,
                            e.friction,
                            e.numerical_dissipation,
                            e.balance_error,
                            e.damping,
                            e.work_correction,
                            e.material};
    row.insert(row.end(), e.work_of_load.begin(), e.work_of_load.end());
    row.insert(row.end(), e.work_of_support.begin(), e.work_of_support.end());
    file_.row(row);
    file_.flush();
}

} // namespace fem

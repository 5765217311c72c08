// SPDX-License-Identifier: MIT
#include "sph_solver/output/energy_table.hpp"

namespace sph {
namespace {

std::vector<std::string> header(int dimension)
{
    const std::string joule = dimension == 2 ? "[J/m]" : "[J]";
    const std::string kilogram = dimension == 2 ? "[kg/m]" : "[kg]";
    const std::string momentum = dimension == 2 ? "[kg/s]" : "[kg m/s]";
    std::vector<std::string> columns = {"t[s]", "dt[s]"};
    for (const char* name : {"kinetic", "potential", "internal", "total"}) columns.push_back(name + joule);
    columns.push_back("mass" + kilogram);
    for (const char* name : {"work_by_walls", "work_by_interface"}) columns.push_back(name + joule);
    columns.push_back("outflow_mass" + kilogram);
    for (const char* axis : {"x", "y", "z"}) columns.push_back(std::string("outflow_momentum_") + axis + momentum);
    for (const char* name : {"outflow_energy", "dissipation_riemann", "dissipation_mass_flux", "dissipation_walls",
                             "viscous", "balance_error"}) {
        columns.push_back(name + joule);
    }
    for (const char* name : {"momentum_", "impulse_of_walls_", "impulse_of_interface_"})
        for (const char* axis : {"x", "y", "z"}) columns.push_back(std::string(name) + axis + momentum);
    columns.insert(columns.end(), {"trapped_particles[-]", "trapped_mass" + kilogram, "trapped_energy" + joule});
    return columns;
}

} // namespace

EnergyTable::EnergyTable(const std::string& folder, int dimension) : file_(folder + "/energy.csv", header(dimension)) {}

void EnergyTable::write(const EnergyRow& row)
{
    std::vector<double> values = {row.time,
                                  row.dt,
                                  row.kinetic,
                                  row.potential,
                                  row.internal,
                                  row.total(),
                                  row.mass,
                                  row.work_by_walls,
                                  row.work_by_interface,
                                  row.outflow_mass,
                                  row.outflow_momentum[0],
                                  row.outflow_momentum[1],
                                  row.outflow_momentum[2],
                                  row.outflow_energy,
                                  row.dissipation_riemann,
                                  row.dissipation_mass_flux,
                                  row.dissipation_walls,
                                  row.viscous,
                                  row.balance_error};
    for (const auto& vector : {row.momentum, row.impulse_of_walls, row.impulse_of_interface})
        values.insert(values.end(), vector.begin(), vector.end());
    values.insert(values.end(), {row.trapped_particles, row.trapped_mass, row.trapped_energy});
    file_.row(values);
}

} // namespace sph

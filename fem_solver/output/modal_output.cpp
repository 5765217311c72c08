// SPDX-License-Identifier: MIT
#include "fem_solver/output/modal_output.hpp"

#include "coupler_lib/base/csv.hpp"

namespace fem {

void write_modes(const std::string& folder, int dimension, const std::vector<Mode>& modes)
{
    std::vector<std::string> header{"mode[-]", "frequency[Hz]", "angular_frequency[rad/s]", "residual[-]"};
    for (int k = 0; k < dimension; ++k)
        header.push_back(std::string("mass_") + "xyz"[k] + (dimension == 2 ? "[kg/m]" : "[kg]"));
    base::CsvWriter table(folder + "/modes.csv", header);
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const Mode& mode = modes[i];
        std::vector<double> row{static_cast<double>(i + 1), mode.frequency(), mode.angular_frequency, mode.residual};
        row.insert(row.end(), mode.masses.begin(), mode.masses.end());
        table.row(row);
    }
}

void write_shapes(FieldFile& fields, const Mesh& mesh, const DofMap& dofs, const Motion& state,
                  const std::vector<Mode>& modes,
                  const std::function<std::vector<double>(const Eigen::VectorXd&)>& stress)
{
    const double extent = bounding_box(mesh).longest_side();
    Motion shown = state;
    fields.write(0, shown, stress(shown.displacement), {});
    for (std::size_t i = 0; i < modes.size(); ++i) {
        shown.displacement = state.displacement + 0.05 * extent / dofs.largest(modes[i].shape) * modes[i].shape;
        fields.write(static_cast<double>(i + 1), shown, stress(shown.displacement), {});
    }
}

} // namespace fem

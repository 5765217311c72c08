// SPDX-License-Identifier: MIT
#include "fem_solver/output/field_file.hpp"

#include "fem_solver/output/xdmf_order.hpp"

#include <array>

namespace fem {
namespace {

constexpr std::array<const char*, 10> xdmf_names{"triangle",        "triangle_6",   "quadrilateral",  "quadrilateral_8",
                                                 "quadrilateral_9", "tetrahedron",  "tetrahedron_10", "hexahedron",
                                                 "hexahedron_20",   "hexahedron_27"}; // in the order of ElementType

} // namespace

FieldFile::FieldFile(const std::string& folder, const Mesh& mesh, const DofMap& dofs, const base::Communicator& comm)
    : mesh_(&mesh), file_(folder + "/fields", comm)
{
    topology_.kind = xdmf_names[static_cast<std::size_t>(mesh.type)];
    topology_.nodes_per_cell = mesh.nodes_per_element();
    const std::size_t n = mesh.nodes_per_element();
    const auto& equations = dofs.equations(); // they count nodes rank by rank as well
    for (std::size_t i = 0; i < n * static_cast<std::size_t>(mesh.own_elements()); ++i) {
        const auto node = static_cast<std::size_t>(mesh.connectivity[i - i % n + own_place(mesh.type, i % n)]);
        topology_.connectivity.push_back(equations[node * static_cast<std::size_t>(mesh.dimension)] / mesh.dimension);
    }
}

/// Three components per own node, as files want them.
std::vector<double> FieldFile::in_space(const Eigen::VectorXd& field) const
{
    const int d = mesh_->dimension;
    std::vector<double> result(3 * static_cast<std::size_t>(mesh_->own_nodes()), 0.0);
    for (int i = 0; i < mesh_->own_nodes(); ++i)
        for (int k = 0; k < d; ++k) result[3 * i + k] = field[i * d + k];
    return result;
}

void FieldFile::write(double time, const Motion& motion, const std::vector<double>& stress,
                      const ContactFields& contact)
{
    const Eigen::Map<const Eigen::VectorXd> reference(mesh_->coordinates.data(), std::ssize(mesh_->coordinates));
    const auto spatial = [this](const Eigen::VectorXd& field) { return [this, &field] { return in_space(field); }; };
    const auto copy_of = [](const std::vector<double>& values) { return [&values] { return values; }; };
    std::vector<base::XdmfField> fields{
        {"displacement", "m", "from the reference position", 3, spatial(motion.displacement), "Node"},
        {"velocity", "m/s", "of the nodes", 3, spatial(motion.velocity), "Node"},
        {"stress", "Pa", "Cauchy stress, mean over the element", 9, copy_of(stress), "Cell"}};
    if (!contact.pressure.empty()) {
        fields.push_back({"contact_pressure", "Pa", "per present area", 1, copy_of(contact.pressure), "Node"});
        fields.push_back(
            {"contact_slip", "m", "length of the way slipped in contact", 1, copy_of(contact.slip), "Node"});
    }
    file_.write(time, topology_, in_space(reference + motion.displacement), fields);
}

} // namespace fem

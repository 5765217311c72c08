// SPDX-License-Identifier: MIT
#include "fem_solver/output/field_file.hpp"

namespace fem {
namespace {

std::string xdmf_name(ElementType type)
{
    switch (type) {
    case ElementType::quad4:
        return "quadrilateral";
    case ElementType::quad8:
        return "quadrilateral_8";
    case ElementType::hexa8:
        return "hexahedron";
    default:
        return "hexahedron_20";
    }
}

} // namespace

FieldFile::FieldFile(const std::string& folder, const Mesh& mesh, const base::Communicator& comm)
    : mesh_(&mesh), file_(folder + "/fields", comm)
{
    topology_.kind = xdmf_name(mesh.type);
    topology_.nodes_per_cell = mesh.nodes_per_element();
    const int n = mesh.nodes_per_element();
    for (std::size_t i = 0; i < mesh.connectivity.size(); ++i) {
        std::size_t from = i;
        if (mesh.type == ElementType::hexa20) { // XDMF lists the edges of the upper face before the upright ones
            const std::size_t a = i % n, start = i - a;
            if (a >= 12) from = start + (a < 16 ? a + 4 : a - 4);
        }
        topology_.connectivity.push_back(mesh.connectivity[from]);
    }
}

/// Three components per node, as files want them.
std::vector<double> FieldFile::in_space(const Eigen::VectorXd& field) const
{
    const int d = mesh_->dimension;
    std::vector<double> result(3 * static_cast<std::size_t>(mesh_->nodes()), 0.0);
    for (int i = 0; i < mesh_->nodes(); ++i)
        for (int k = 0; k < d; ++k) result[3 * i + k] = field[i * d + k];
    return result;
}

void FieldFile::write(double time, const Motion& motion, const std::vector<double>& stress)
{
    const Eigen::Map<const Eigen::VectorXd> reference(mesh_->coordinates.data(), std::ssize(mesh_->coordinates));
    const std::vector<double> points = in_space(reference + motion.displacement);
    const std::vector<double> displacement = in_space(motion.displacement);
    const std::vector<double> velocity = in_space(motion.velocity);
    file_.write(time, topology_, points,
                {{"displacement", "m", "from the reference position", 3, &displacement, "Node"},
                 {"velocity", "m/s", "of the nodes", 3, &velocity, "Node"},
                 {"stress", "Pa", "Cauchy stress, mean over the element", 9, &stress, "Cell"}});
}

} // namespace fem

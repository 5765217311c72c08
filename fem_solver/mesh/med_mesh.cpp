// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/med_mesh.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/mesh/face_finder.hpp"
#include "fem_solver/mesh/med_file.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace fem {
namespace {

/// The one kind of cells that makes the body.
const MedCells& body_cells(const MedContent& content, const MedSpec& spec)
{
    const MedCells* body = nullptr;
    std::string kinds;
    int found = 0;
    for (const MedCells& cells : content.cells) {
        kinds += base::text(kinds.empty() ? "" : ", ", cells.count(), " ", cells.name);
        if (cells.dimension != spec.dimension) continue;
        body = &cells;
        ++found;
    }
    base::require_input(found > 0, "'", spec.path, "': the model has the dimension ", spec.dimension,
                        ", the mesh has no such cells, only ", kinds.empty() ? "none at all" : kinds);
    base::require_input(found == 1, "'", spec.path, "': a body is made of elements of one type, the mesh has ", kinds,
                        ". Mesh it anew with one type (Gmsh: recombine all surfaces or none)");
    base::require_input(body->type.has_value(), "'", spec.path, "': ", body->name,
                        " cells cannot be computed; use triangles, quadrilaterals, tetrahedra or hexahedra");
    return *body;
}

/// New number of each node of the file, -1 for those of no element; copies the others' positions.
std::vector<int> take_nodes(const MedContent& content, const MedCells& body, const MedSpec& spec, Mesh& mesh)
{
    const auto space = static_cast<std::size_t>(content.dimension);
    base::require_input(content.dimension >= spec.dimension, "'", spec.path, "': nodes have ", content.dimension,
                        " coordinates, the model has the dimension ", spec.dimension);
    std::vector<int> number(content.points.size() / space, -1);
    for (const int node : body.connectivity) number[static_cast<std::size_t>(node)] = 0;
    const double* plane = content.points.data() + space * static_cast<std::size_t>(body.connectivity.front());
    double extent = 0, off = 0;
    int next = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] < 0) continue;
        number[i] = next++;
        for (std::size_t k = 0; k < space; ++k) {
            const double x = content.points[i * space + k];
            if (k < static_cast<std::size_t>(spec.dimension)) {
                mesh.coordinates.push_back(spec.scale * x);
                extent = std::max(extent, std::abs(x - plane[k]));
            } else {
                off = std::max(off, std::abs(x - plane[k]));
            }
        }
    }
    base::require_input(off <= 1e-9 * extent, "'", spec.path,
                        "': a plane model needs a mesh in the plane z = constant; ", "its nodes differ by ", off,
                        " along z");
    return number;
}

/// Puts faces and nodes into the mesh's groups by the families of the file.
class Grouping {
public:
    Grouping(const MedContent& content, const std::vector<int>& number, const MedSpec& spec, Mesh& mesh)
        : content_(content), number_(number), spec_(spec), mesh_(mesh), finder_(mesh)
    {}

    void add(const MedCells& cells)
    {
        for (int c = 0; c < cells.count(); ++c)
            for (const std::string& group : groups_of(cells.families[static_cast<std::size_t>(c)])) {
                const std::vector<int> nodes = nodes_of(cells, c);
                if (cells.dimension == spec_.dimension - 1)
                    mesh_.face_groups[group].push_back(face(cells, c, nodes, group));
                for (const int node : nodes)
                    if (node >= 0) nodes_[group].insert(node);
            }
    }

    void add_nodes()
    {
        for (std::size_t i = 0; i < content_.node_families.size(); ++i)
            for (const std::string& group : groups_of(content_.node_families[i]))
                if (number_[i] >= 0) nodes_[group].insert(number_[i]);
    }

    void finish()
    {
        for (const auto& [group, nodes] : nodes_) mesh_.node_groups[group].assign(nodes.begin(), nodes.end());
        for (const auto& [family, groups] : content_.groups)
            for (const std::string& group : groups)
                base::require_input(mesh_.node_groups.contains(group), "'", spec_.path, "': the group '", group,
                                    "' holds no node of the body");
    }

private:
    const std::vector<std::string>& groups_of(int family) const
    {
        static const std::vector<std::string> none;
        const auto found = content_.groups.find(family);
        return found == content_.groups.end() ? none : found->second;
    }

    std::vector<int> nodes_of(const MedCells& cells, int c) const
    {
        std::vector<int> nodes;
        for (int a = 0; a < cells.nodes; ++a)
            nodes.push_back(
                number_[static_cast<std::size_t>(cells.connectivity[static_cast<std::size_t>(c * cells.nodes + a)])]);
        return nodes;
    }

    MeshFace face(const MedCells& cells, int c, const std::vector<int>& nodes, const std::string& group) const
    {
        const auto owners = finder_.find(nodes);
        const auto what = [&] {
            const auto on_body = std::ranges::find_if(nodes, [](int node) { return node >= 0; });
            return base::text("'", spec_.path, "': ", cells.name, " ", c + 1, " of the group '", group, "'",
                              on_body == nodes.end() ? "" : " at " + mesh_.describe_node(*on_body) + " m");
        };
        base::require_input(!owners.empty(), what(), " is the face of no element of the body");
        base::require_input(owners.size() == 1, what(), " lies inside the body, between the elements ",
                            owners.front().element, " and ", owners.back().element);
        return owners.front();
    }

    const MedContent& content_;
    const std::vector<int>& number_;
    const MedSpec& spec_;
    Mesh& mesh_;
    FaceFinder finder_;
    std::map<std::string, std::set<int>> nodes_;
};

} // namespace

Mesh read_med_mesh(const MedSpec& spec)
{
    const MedContent content = read_med(spec.path, spec.mesh);
    const MedCells& body = body_cells(content, spec);
    Mesh mesh;
    mesh.type = *body.type;
    mesh.dimension = spec.dimension;
    const std::vector<int> number = take_nodes(content, body, spec, mesh);
    for (const int node : body.connectivity) mesh.connectivity.push_back(number[static_cast<std::size_t>(node)]);
    try {
        check_jacobians(mesh);
    } catch (const base::Error& error) {
        throw base::Error(error.code(), "'" + spec.path + "': " + error.what());
    }
    Grouping grouping(content, number, spec, mesh);
    for (const MedCells& cells : content.cells) grouping.add(cells);
    grouping.add_nodes();
    grouping.finish();
    return mesh;
}

} // namespace fem

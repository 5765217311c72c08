// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/block_mesh.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/mesh/cell_elements.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace fem {
namespace {

constexpr std::array<const char*, 6> side_names{"left", "right", "bottom", "top", "back", "front"};

/// Points of the block on which nodes may lie: spaced by a cell (linear) or by half a cell (quadratic elements).
struct Lattice {
    std::array<int, 3> size{1, 1, 1};
    int step = 1; ///< lattice points per cell
    std::vector<int> node;

    int index(const LatticePoint& p) const { return p[0] + size[0] * (p[1] + size[1] * p[2]); }
};

void check(const BlockSpec& spec, int dimension)
{
    const auto n = static_cast<std::size_t>(dimension);
    base::require_input(spec.low.size() == n && spec.high.size() == n && spec.cells.size() == n, "a block of ",
                        name_of(spec.element), " needs low, high and cells with ", n, " entries each; they have ",
                        spec.low.size(), ", ", spec.high.size(), " and ", spec.cells.size());
    for (std::size_t k = 0; k < n; ++k) {
        base::require_input(spec.low[k] < spec.high[k], "block: low[", k, "] = ", spec.low[k], " m must be below high[",
                            k, "] = ", spec.high[k], " m");
        base::require_input(spec.cells[k] >= 1, "block: cells[", k, "] = ", spec.cells[k], " must be at least 1");
    }
}

template<class Shape> constexpr bool serendipity = std::is_same_v<Shape, Quad8> || std::is_same_v<Shape, Hexa20>;

/// Serendipity elements have nodes on corners and edges only: at most one odd lattice index.
template<class Shape> bool carries_node(const LatticePoint& p)
{
    return !serendipity<Shape> || (p[0] % 2) + (p[1] % 2) + (p[2] % 2) <= 1;
}

template<class Shape> Lattice number_nodes(const BlockSpec& spec, Mesh& mesh)
{
    Lattice lattice;
    lattice.step = Shape::linear ? 1 : 2;
    for (int k = 0; k < mesh.dimension; ++k) lattice.size[k] = lattice.step * spec.cells[k] + 1;
    LatticePoint p{};
    for (p[2] = 0; p[2] < lattice.size[2]; ++p[2])
        for (p[1] = 0; p[1] < lattice.size[1]; ++p[1])
            for (p[0] = 0; p[0] < lattice.size[0]; ++p[0]) {
                lattice.node.push_back(carries_node<Shape>(p) ? mesh.nodes() : -1);
                if (lattice.node.back() < 0) continue;
                for (int k = 0; k < mesh.dimension; ++k)
                    mesh.coordinates.push_back(spec.low[k] +
                                               (spec.high[k] - spec.low[k]) * p[k] / (lattice.size[k] - 1));
            }
    return lattice;
}

/// Which side of the block a face lies on, or -1: all its lattice points at the same end of one direction.
template<class Face>
int side_of(const Face& face, const std::vector<LatticePoint>& points, const Lattice& lattice, int d)
{
    for (int k = 0; k < d; ++k)
        for (const int end : {0, lattice.size[k] - 1})
            if (std::ranges::all_of(face, [&](int a) { return points[a][k] == end; })) return 2 * k + (end > 0);
    return -1;
}

/// \param points of the element's nodes on the lattice.
template<class Shape> void add_element(Mesh& mesh, const Lattice& lattice, const std::vector<LatticePoint>& points)
{
    const int element = mesh.elements();
    for (const LatticePoint& p : points) mesh.connectivity.push_back(lattice.node[lattice.index(p)]);
    for (int f = 0; f < static_cast<int>(Shape::faces.size()); ++f) {
        const int side = side_of(Shape::faces[f], points, lattice, Shape::dimension);
        if (side < 0) continue;
        mesh.face_groups[side_names[side]].push_back({element, f});
        mesh.face_groups["all"].push_back({element, f});
    }
}

template<class Shape> void fill(Mesh& mesh, const BlockSpec& spec)
{
    const Lattice lattice = number_nodes<Shape>(spec, mesh);
    const auto cell_elements = elements_of_cell<Shape>(lattice.step);
    const int layers = Shape::dimension == 3 ? spec.cells[2] : 1;
    LatticePoint cell{};
    for (cell[2] = 0; cell[2] < layers; ++cell[2])
        for (cell[1] = 0; cell[1] < spec.cells[1]; ++cell[1])
            for (cell[0] = 0; cell[0] < spec.cells[0]; ++cell[0])
                for (std::vector<LatticePoint> points : cell_elements) {
                    for (LatticePoint& p : points)
                        for (int k = 0; k < 3; ++k) p[k] += lattice.step * cell[k];
                    add_element<Shape>(mesh, lattice, points);
                }
}

} // namespace

Mesh make_block(const BlockSpec& spec)
{
    Mesh mesh;
    mesh.type = spec.element;
    mesh.dimension = dimension_of(spec.element);
    check(spec, mesh.dimension);
    with_shape(spec.element, [&](auto shape) { fill<decltype(shape)>(mesh, spec); });
    for (const auto& [name, faces] : mesh.face_groups) {
        std::set<int> nodes;
        for (const MeshFace& face : faces)
            for (const int node : mesh.face_nodes(face)) nodes.insert(node);
        mesh.node_groups[name].assign(nodes.begin(), nodes.end());
    }
    auto& all = mesh.node_groups["all"];
    all.resize(mesh.nodes());
    for (int i = 0; i < mesh.nodes(); ++i) all[i] = i;
    return mesh;
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/mesh/med_file.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/mesh/med_orders.hpp"

#include <algorithm>
#include <cstdio>

namespace fem {
namespace {

/// Text of a fixed width as the format stores it: cut at the first null, blanks at the end removed.
std::string trimmed(const std::vector<char>& buffer, std::size_t begin, std::size_t width)
{
    std::string text(buffer.data() + begin, width);
    text = text.c_str();
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

/// An open file; says which file it was when a call of the library fails.
class MedFile {
public:
    explicit MedFile(const std::string& path) : path_(path)
    {
        std::FILE* there = std::fopen(path.c_str(), "rb");
        base::require_input(there != nullptr, "the mesh file '", path, "' cannot be opened");
        std::fclose(there);
        H5Eset_auto(H5E_DEFAULT, nullptr, nullptr); // what goes wrong is said here, in one line
        med_bool hdf_ok = MED_FALSE, med_ok = MED_FALSE;
        const bool looked = MEDfileCompatibility(path.c_str(), &hdf_ok, &med_ok) >= 0;
        base::require_input(looked && hdf_ok, "'", path,
                            "' is no MED file, or it is cut off: it does not open as HDF5");
        base::require_input(med_ok, "'", path, "' is of no version of MED that this library (", MED_MAJOR_NUM, ".",
                            MED_MINOR_NUM, ") reads, or it is cut off: save it again, as MED ", MED_MAJOR_NUM);
        id_ = MEDfileOpen(path.c_str(), MED_ACC_RDONLY);
        base::require_input(id_ >= 0, "the mesh file '", path, "' cannot be read");
    }
    MedFile(const MedFile&) = delete;
    ~MedFile()
    {
        if (id_ >= 0) MEDfileClose(id_);
    }

    med_idt id() const { return id_; }
    const std::string& path() const { return path_; }
    /// The answer of a call that reads `what`, or an error.
    med_int must(med_int answer, const std::string& what) const
    {
        base::require_input(answer >= 0, "'", path_, "': ", what, " cannot be read; the file may be cut off");
        return answer;
    }

private:
    std::string path_;
    med_idt id_ = -1;
};

/// Name of the wanted mesh and the dimension of its space.
void find_mesh(const MedFile& file, const std::string& wanted, MedContent& content)
{
    const med_int count = file.must(MEDnMesh(file.id()), "the number of meshes");
    base::require_input(count > 0, "'", file.path(), "' holds no mesh");
    std::string known;
    for (med_int k = 1; k <= count; ++k) {
        std::vector<char> name(MED_NAME_SIZE + 1), text(MED_COMMENT_SIZE + 1), unit(MED_SNAME_SIZE + 1),
            axes(3 * MED_SNAME_SIZE + 1), units(3 * MED_SNAME_SIZE + 1);
        med_int space = 0, dimension = 0, steps = 0;
        med_mesh_type type{};
        med_sorting_type sorting{};
        med_axis_type axis{};
        file.must(MEDmeshInfo(file.id(), static_cast<int>(k), name.data(), &space, &dimension, &type, text.data(),
                              unit.data(), &sorting, &steps, &axis, axes.data(), units.data()),
                  "the description of mesh " + std::to_string(k));
        const std::string found = trimmed(name, 0, MED_NAME_SIZE);
        known += (known.empty() ? "'" : ", '") + found + "'";
        if (!wanted.empty() && wanted != found) continue;
        base::require_input(type == MED_UNSTRUCTURED_MESH, "'", file.path(), "': the mesh '", found,
                            "' is a structured grid; save it as an unstructured mesh");
        base::require_input(axis == MED_CARTESIAN, "'", file.path(), "': the mesh '", found,
                            "' is not in Cartesian coordinates");
        base::require_input(content.mesh.empty(), "'", file.path(),
                            "' holds several meshes, choose one by [mesh] name: ", known);
        content.mesh = found;
        content.dimension = static_cast<int>(space);
    }
    base::require_input(!content.mesh.empty(), "'", file.path(), "' has no mesh '", wanted, "'; it has ", known);
}

med_int size_of(const MedFile& file, const std::string& mesh, med_entity_type entity, med_geometry_type type,
                med_data_type data, med_connectivity_mode mode)
{
    med_bool changed{}, transformed{};
    return MEDmeshnEntity(file.id(), mesh.c_str(), MED_NO_DT, MED_NO_IT, entity, type, data, mode, &changed,
                          &transformed);
}

/// Families of entities; all zero where the file says none.
std::vector<int> families(const MedFile& file, const std::string& mesh, med_entity_type entity, med_geometry_type type,
                          std::size_t count)
{
    std::vector<med_int> numbers(count, 0);
    if (size_of(file, mesh, entity, type, MED_FAMILY_NUMBER, MED_NODAL) > 0)
        file.must(
            MEDmeshEntityFamilyNumberRd(file.id(), mesh.c_str(), MED_NO_DT, MED_NO_IT, entity, type, numbers.data()),
            "families");
    return {numbers.begin(), numbers.end()};
}

void read_nodes(const MedFile& file, MedContent& content)
{
    const char* mesh = content.mesh.c_str();
    const med_int count =
        file.must(size_of(file, mesh, MED_NODE, MED_NONE, MED_COORDINATE, MED_NO_CMODE), "the number of nodes");
    base::require_input(count > 0, "'", file.path(), "': the mesh '", mesh, "' has no nodes");
    content.points.resize(static_cast<std::size_t>(count) * content.dimension);
    file.must(MEDmeshNodeCoordinateRd(file.id(), mesh, MED_NO_DT, MED_NO_IT, MED_FULL_INTERLACE, content.points.data()),
              "the coordinates");
    content.node_families = families(file, mesh, MED_NODE, MED_NONE, static_cast<std::size_t>(count));
}

void read_cells(const MedFile& file, const MedKind& kind, MedContent& content)
{
    const char* mesh = content.mesh.c_str();
    const med_int count = size_of(file, mesh, MED_CELL, kind.code, MED_CONNECTIVITY, MED_NODAL);
    if (count <= 0) return;
    const auto n = static_cast<std::size_t>(kind.nodes);
    std::vector<med_int> nodes(n * static_cast<std::size_t>(count));
    file.must(MEDmeshElementConnectivityRd(file.id(), mesh, MED_NO_DT, MED_NO_IT, MED_CELL, kind.code, MED_NODAL,
                                           MED_FULL_INTERLACE, nodes.data()),
              std::string("the nodes of the ") + kind.name);
    const med_int last = static_cast<med_int>(content.points.size()) / content.dimension;
    const auto wrong = std::ranges::find_if(nodes, [&](med_int node) { return node < 1 || node > last; });
    base::require_input(wrong == nodes.end(), "'", file.path(), "': ", kind.name, " ",
                        (wrong - nodes.begin()) / kind.nodes + 1, " has a node ", wrong == nodes.end() ? 0 : *wrong,
                        "; there are ", last);
    MedCells cells{kind.name, kind.dimension, kind.nodes, kind.type, {}, {}};
    cells.connectivity.reserve(nodes.size());
    for (std::size_t first = 0; first < nodes.size(); first += n)
        for (std::size_t a = 0; a < n; ++a)
            cells.connectivity.push_back(
                static_cast<int>(nodes[first + static_cast<std::size_t>(kind.order.empty() ? a : kind.order[a])]) - 1);
    cells.families = families(file, mesh, MED_CELL, kind.code, static_cast<std::size_t>(count));
    content.cells.push_back(std::move(cells));
}

void read_groups(const MedFile& file, MedContent& content)
{
    const char* mesh = content.mesh.c_str();
    const med_int count = file.must(MEDnFamily(file.id(), mesh), "the number of families");
    for (int k = 1; k <= count; ++k) {
        const auto groups =
            static_cast<std::size_t>(file.must(MEDnFamilyGroup(file.id(), mesh, k), "the groups of a family"));
        std::vector<char> family(MED_NAME_SIZE + 1), names(groups * MED_LNAME_SIZE + 1);
        med_int number = 0;
        file.must(MEDfamilyInfo(file.id(), mesh, k, family.data(), &number, names.data()), "a family");
        for (std::size_t g = 0; g < groups; ++g)
            content.groups[static_cast<int>(number)].push_back(trimmed(names, g * MED_LNAME_SIZE, MED_LNAME_SIZE));
    }
}

} // namespace

MedContent read_med(const std::string& path, const std::string& mesh)
{
    const MedFile file(path);
    MedContent content;
    find_mesh(file, mesh, content);
    read_nodes(file, content);
    for (const MedKind& kind : med_kinds) read_cells(file, kind, content);
    read_groups(file, content);
    return content;
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "coupler_lib/base/xdmf.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <map>

namespace base {
namespace {

const char* xdmf_topology(const std::string& kind)
{
    static const std::map<std::string, const char*> names = {
        {"polyvertex", "Polyvertex"},           {"triangle", "Triangle"},
        {"triangle_6", "Triangle_6"},           {"quadrilateral", "Quadrilateral"},
        {"quadrilateral_8", "Quadrilateral_8"}, {"quadrilateral_9", "Quadrilateral_9"},
        {"tetrahedron", "Tetrahedron"},         {"tetrahedron_10", "Tetrahedron_10"},
        {"hexahedron", "Hexahedron"},           {"hexahedron_20", "Hexahedron_20"},
        {"hexahedron_27", "Hexahedron_27"}};
    const auto found = names.find(kind);
    ensure(found != names.end(), "the XDMF topology is known");
    return found->second;
}

std::string data_item(const std::string& file, const std::string& path, std::int64_t rows, int columns,
                      const char* type)
{
    const std::string shape = columns == 1 ? fmt::format("{}", rows) : fmt::format("{} {}", rows, columns);
    return fmt::format("<DataItem Dimensions=\"{}\" {} Precision=\"8\" Format=\"HDF\">{}:{}</DataItem>", shape, type,
                       file, path);
}

const char* attribute_type(int columns) { return columns == 1 ? "Scalar" : columns == 3 ? "Vector" : "Tensor"; }

} // namespace

XdmfWriter::XdmfWriter(const std::string& path_without_extension, const Communicator& comm)
    : path_(path_without_extension), comm_(comm), file_(Hdf5File::create(path_without_extension + ".h5", comm))
{}

void XdmfWriter::write(double time, const XdmfTopology& topology, std::vector<double> points,
                       const std::vector<XdmfField>& fields)
{
    const std::string group = fmt::format("/step_{:06d}", grids_.size());
    file_.create_group(group);
    file_.attribute(group, "time", time);
    const std::size_t my_points = points.size() / 3;
    file_.write_rows(group + "/points", points.data(), my_points, 3);
    points = std::vector<double>(); // with its memory
    const auto nodes = static_cast<std::size_t>(topology.nodes_per_cell);
    if (topology.kind != "polyvertex")
        file_.write_rows(group + "/connectivity", topology.connectivity.data(), topology.connectivity.size() / nodes,
                         topology.nodes_per_cell);
    for (const auto& field : fields) {
        const std::string path = group + "/" + field.name;
        const std::vector<double> values = field.values();
        file_.write_rows(path, values.data(), values.size() / static_cast<std::size_t>(field.columns), field.columns);
        file_.attribute(path, "unit", field.unit);
        file_.attribute(path, "description", field.description);
    }
    file_.flush();
    const auto all_points = comm_.sum(static_cast<std::int64_t>(my_points));
    const auto all_cells = comm_.sum(static_cast<std::int64_t>(topology.connectivity.size() / nodes));
    grids_.push_back(grid_text(time, group, topology, all_points, all_cells, fields));
    if (comm_.is_root()) write_index();
}

std::string XdmfWriter::grid_text(double time, const std::string& group, const XdmfTopology& topology,
                                  std::int64_t points, std::int64_t cells, const std::vector<XdmfField>& fields) const
{
    const std::string file = std::filesystem::path(path_).filename().string() + ".h5";
    const bool particles = topology.kind == "polyvertex";
    std::string grid = fmt::format("<Grid Name=\"{}\"><Time Value=\"{:.12g}\"/>\n", group.substr(1), time);
    grid += fmt::format("<Topology TopologyType=\"{}\" NumberOfElements=\"{}\"", xdmf_topology(topology.kind),
                        particles ? points : cells);
    grid += particles
                ? " NodesPerElement=\"1\"/>\n"
                : ">" + data_item(file, group + "/connectivity", cells, topology.nodes_per_cell, "NumberType=\"Int\"") +
                      "</Topology>\n";
    grid += "<Geometry GeometryType=\"XYZ\">" + data_item(file, group + "/points", points, 3, "NumberType=\"Float\"") +
            "</Geometry>\n";
    for (const auto& field : fields) {
        const std::int64_t rows = field.centre == "Node" ? points : cells;
        grid += fmt::format("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">", field.name,
                            attribute_type(field.columns), field.centre);
        grid +=
            data_item(file, group + "/" + field.name, rows, field.columns, "NumberType=\"Float\"") + "</Attribute>\n";
    }
    return grid + "</Grid>\n";
}

void XdmfWriter::write_index() const
{
    const std::string finished = path_ + ".xdmf", draft = finished + ".new";
    {
        std::ofstream file(draft);
        file << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\"><Domain>\n"
             << "<Grid Name=\"series\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
        for (const auto& grid : grids_) file << grid;
        file << "</Grid>\n</Domain></Xdmf>\n";
        require(file.good(), ExitCode::bad_input, "cannot write the file '", draft, "'; is the disk full?");
    }
    std::filesystem::rename(draft, finished);
}

} // namespace base

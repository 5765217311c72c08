// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/hdf5_file.hpp"

#include <functional>
#include <string>
#include <vector>

namespace base {

/// How points are joined to cells. Kinds: "polyvertex" (particles; connectivity unused), "quadrilateral",
/// "quadrilateral_8", "quadrilateral_9", "triangle", "triangle_6", "tetrahedron", "tetrahedron_10", "hexahedron",
/// "hexahedron_20", "hexahedron_27". Connectivity holds global point numbers, row by row.
struct XdmfTopology {
    std::string kind = "polyvertex";
    std::vector<std::int64_t> connectivity = {};
    int nodes_per_cell = 1;
};

/// One field of a time step: `columns` numbers (1, 3 or 9) for each point or cell of this rank.
struct XdmfField {
    std::string name, unit, description;
    int columns = 1;
    std::function<std::vector<double>()>
        values;                  ///< asked for when the field is written, so that one is in memory at a time
    std::string centre = "Node"; ///< "Node" or "Cell"
};

/// A series of time steps in NAME.h5 with NAME.xdmf beside it, which ParaView opens.
///
/// Layout of the HDF5 file: /step_000000 with attribute time [s], and in it `points` (N x 3), `connectivity` and one
/// dataset a field, with attributes unit and description. Both files are complete after every write.
class XdmfWriter {
public:
    XdmfWriter(const std::string& path_without_extension, const Communicator& comm);

    /// Collective. `points` holds three numbers for each point of this rank [m]; given up before the fields are made.
    void write(double time, const XdmfTopology& topology, std::vector<double> points,
               const std::vector<XdmfField>& fields);

private:
    std::string grid_text(double time, const std::string& group, const XdmfTopology& topology, std::int64_t points,
                          std::int64_t cells, const std::vector<XdmfField>& fields) const;
    void write_index() const;

    std::string path_;
    Communicator comm_;
    Hdf5File file_;
    std::vector<std::string> grids_;
};

} // namespace base

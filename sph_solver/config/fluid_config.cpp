// SPDX-License-Identifier: MIT
#include "sph_solver/config/fluid_config.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <cmath>
#include <filesystem>
#include <set>
#include <string>

namespace sph {
namespace {

/// Checks vectors given in the file for one number a dimension; an empty one is filled with zeros where allowed.
class VectorCheck {
public:
    VectorCheck(const base::ConfigReader& reader, int dimension)
        : reader_(reader), dimension_(static_cast<std::size_t>(dimension))
    {}

    template<class T> void required(const std::vector<T>& numbers, const std::string& path) const
    {
        base::require_input(numbers.size() == dimension_, reader_.where(path), ": ", path, " has ", numbers.size(),
                            " numbers; in ", dimension_, "D it needs ", dimension_);
    }

    void optional(std::vector<double>& numbers, const std::string& path) const
    {
        if (numbers.empty()) numbers.assign(dimension_, 0.0);
        required(numbers, path);
    }

    void box(const std::vector<double>& low, const std::vector<double>& high, const std::string& path) const
    {
        required(low, path + ".low");
        required(high, path + ".high");
        for (std::size_t d = 0; d < dimension_; ++d) {
            base::require_input(low[d] < high[d], reader_.where(path), ": low (", low[d], " m) is not below high (",
                                high[d], " m) along axis ", d, ": the box has no volume");
        }
    }

private:
    const base::ConfigReader& reader_;
    std::size_t dimension_;
};

std::string element(const char* table, std::size_t k) { return std::string(table) + "." + std::to_string(k); }

/// A path in the file is seen from the file's folder.
void resolve(std::string& path, const base::ConfigReader& reader)
{
    if (!path.empty()) path = (std::filesystem::path(reader.file_name()).parent_path() / path).string();
}

void check_water_shape(const WaterConfig& water, const std::string& where, int dimension)
{
    const std::string& shape = water.shape;
    const bool flat = shape == "disc" || shape == "polygon";
    base::require_input(!flat || dimension == 2, where, ": a ", shape, " is a shape in 2D");
    base::require_input(shape != "stl" || dimension == 3, where, ": an STL file is a shape in 3D; use a polygon in 2D");
    base::require_input(shape != "disc" || water.radius > 0.0, where, ": a disc needs a radius above zero");
    base::require_input(shape != "polygon" || water.points.size() >= 3, where,
                        ": a polygon needs three points at least, points = [[x, y], ...]; it has ",
                        water.points.size());
    for (const auto& point : water.points)
        base::require_input(point.size() == 2, where, ": a point of the polygon has ", point.size(), " numbers, not 2");
    const bool wants_file = shape == "stl" || shape == "particles" || shape == "film";
    base::require_input(wants_file != water.file.empty(), where, ": shape \"", shape,
                        wants_file ? "\" needs a file = \"...\"" : "\" has no file; is shape = \"stl\" meant?");
}

void check_water(FluidConfig& config, const base::ConfigReader& reader, const VectorCheck& vectors)
{
    base::require_input(!config.water.empty(), reader.file_name(), ": there is no water; add a table [[water]]");
    for (std::size_t k = 0; k < config.water.size(); ++k) {
        WaterConfig& water = config.water[k];
        const std::string path = element("water", k);
        check_water_shape(water, reader.where(path), config.domain.dimension);
        if (water.shape == "box" || water.shape == "film") vectors.box(water.low, water.high, path);
        if (water.shape == "disc") vectors.required(water.centre, path + ".centre");
        if (!water.velocity.empty()) vectors.required(water.velocity, path + ".velocity");
        resolve(water.file, reader);
    }
    const base::Formula& pressure = config.initial.pressure;
    base::require_input(
        config.initial.state != "hydrostatic" || pressure.where.empty(), pressure.where,
        ": a pressure is given, but state = \"hydrostatic\" makes its own; is \"field\" or \"uniform\" meant?");
}

void check_outflows(const FluidConfig& config, const base::ConfigReader& reader, const VectorCheck& vectors)
{
    for (std::size_t k = 0; k < config.outflows.size(); ++k) {
        const std::string path = element("outflow", k);
        vectors.required(config.outflows[k].point, path + ".point");
        vectors.required(config.outflows[k].normal, path + ".normal");
        double length_squared = 0.0;
        for (const double component : config.outflows[k].normal) length_squared += component * component;
        base::require_input(length_squared > 0.0, reader.where(path), ": normal has no length");
    }
}

void check_probes(FluidConfig& config, const base::ConfigReader& reader, const VectorCheck& vectors)
{
    std::set<std::string> names;
    for (std::size_t k = 0; k < config.probes.size(); ++k) {
        ProbeConfig& probe = config.probes[k];
        const std::string path = element("probes", k);
        const std::string column = probe.name + "." + probe.quantity;
        base::require_input(names.insert(column).second, reader.where(path), ": a probe \"", column,
                            "\" exists already");
        if (probe.quantity == "pressure" || probe.quantity == "velocity" || probe.quantity == "wall_pressure")
            vectors.required(probe.point, path + ".point");
        if (!probe.low.empty() || !probe.high.empty()) vectors.box(probe.low, probe.high, path);
        base::require_input(probe.axis != "z" || config.domain.dimension == 3, reader.where(path),
                            ": axis z exists in 3D only");
    }
}

void check_walls(FluidConfig& config, const base::ConfigReader& reader)
{
    std::set<std::string> names;
    for (std::size_t k = 0; k < config.walls.size(); ++k) {
        base::require_input(names.insert(config.walls[k].name).second, reader.where(element("walls", k)), ": a wall \"",
                            config.walls[k].name, "\" exists already");
        resolve(config.walls[k].file, reader);
        wall_shape(config.walls[k], config.domain.dimension);
        resolve(config.walls[k].motion.table, reader);
        check_motion(config.walls[k], config.domain.dimension);
    }
}

} // namespace

FluidConfig read_fluid_config(base::ConfigReader& reader)
{
    FluidConfig config;
    config.domain = reader.table("domain", domain_table());
    config.time = reader.table("time", time_table());
    config.resolution = reader.table("resolution", resolution_table());
    config.liquid = reader.table("fluid", liquid_table());
    config.initial = reader.table("initial", initial_table());
    config.numerics = reader.table("numerics", numerics_table());
    config.parallel = reader.table("parallel", parallel_table());
    config.output = reader.table("output", output_table());
    config.water = reader.tables("water", water_table());
    config.walls = reader.tables("walls", wall_table());
    config.outflows = reader.tables("outflow", outflow_table());
    config.probes = reader.tables("probes", probe_table());
    if (reader.describing()) return config;
    reader.finish();

    const VectorCheck vectors(reader, config.domain.dimension);
    vectors.optional(config.domain.gravity, "domain.gravity");
    check_water(config, reader, vectors);
    check_walls(config, reader);
    check_outflows(config, reader, vectors);
    check_probes(config, reader, vectors);
    return config;
}

} // namespace sph

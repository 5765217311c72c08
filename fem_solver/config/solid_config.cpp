// SPDX-License-Identifier: MIT
#include "fem_solver/config/solid_config.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace fem {
namespace {

std::string element(const char* table, std::size_t k) { return std::string(table) + "." + std::to_string(k); }

void require_size(const base::ConfigReader& reader, const std::vector<double>& numbers, const std::string& path,
                  int dimension)
{
    base::require_input(std::ssize(numbers) == dimension, reader.where(path), ": ", path, " has ", numbers.size(),
                        " numbers; in ", dimension, "D it needs ", dimension);
}

std::string beside(const base::ConfigReader& reader, const std::string& file)
{
    return (std::filesystem::path(reader.file_name()).parent_path() / file).string();
}

void check_mesh(SolidConfig& config, const base::ConfigReader& reader)
{
    const int d = config.model.dimension;
    if (config.mesh.kind == "med") {
        base::require_input(!config.mesh.file.empty(), reader.where("mesh"),
                            ": a mesh of the kind med needs file = \"FILE.med\"");
        config.mesh.file = beside(reader, config.mesh.file);
        return;
    }
    const bool flat = config.mesh.element.starts_with("quad") || config.mesh.element.starts_with("tri");
    base::require_input(flat == (d == 2), reader.where("mesh.element"), ": element \"", config.mesh.element,
                        "\" does not belong in a model of dimension ", d);
    require_size(reader, config.mesh.low, "mesh.low", d);
    require_size(reader, config.mesh.high, "mesh.high", d);
    require_size(reader, config.mesh.cells, "mesh.cells", d);
    for (int k = 0; k < d; ++k) {
        base::require_input(config.mesh.low[k] < config.mesh.high[k], reader.where("mesh.high"), ": low (",
                            config.mesh.low[k], " m) is not below high (", config.mesh.high[k], " m) along axis ", k);
        base::require_input(config.mesh.cells[k] == std::floor(config.mesh.cells[k]) && config.mesh.cells[k] <= 1e6,
                            reader.where("mesh.cells"), ": ", config.mesh.cells[k], " is no number of cells");
    }
}

/// What the chosen law needs beyond the ranges of the single keys.
void check_law(const MaterialConfig& material, const base::ConfigReader& reader, const std::string& path)
{
    const auto require = [&](bool holds, const char* key, const std::string& what) {
        base::require_input(holds, reader.where(path + "." + key), ": the law ", material.law, " needs ", what);
    };
    if (material.law == "elastic" || material.law == "neo_hookean")
        require(material.young > 0, "E", "E [Pa] above zero");
    if (material.law == "mooney_rivlin")
        require(material.c10 + material.c01 > 0, "c10", "c10 and c01 [Pa] with a sum above zero");
    if (material.law == "marlow") require(!material.curve.empty(), "curve", "curve = \"FILE.csv\"");
    require(material.law == "elastic" || material.kinematics == "finite", "kinematics",
            "finite kinematics: small kinematics goes with the law elastic only");
    require(material.volumetric == "quadratic" || material.law == "neo_hookean", "volumetric",
            "volumetric = \"quadratic\": the logarithmic form is one of neo_hookean");
    if (material.law != "ogden") return;
    require(!material.moduli.empty() && material.moduli.size() == material.exponents.size(), "mu",
            "mu and alpha, as many of both");
    require(std::ranges::count(material.exponents, 0.0) == 0, "alpha", "exponents that are not zero");
    double sum = 0;
    for (const double mu : material.moduli) sum += mu;
    require(sum > 0, "mu", "moduli with a sum above zero");
}

void check_material(SolidConfig& config, const base::ConfigReader& reader,
                    const std::vector<std::pair<std::string, MaterialConfig>>& materials)
{
    base::require_input(materials.size() == 1, reader.file_name(), ": one table [material.NAME] is needed, there are ",
                        materials.size());
    config.material_name = materials.front().first;
    config.material = materials.front().second;
    const std::string path = "material." + config.material_name;
    check_law(config.material, reader, path);
    std::string& curve = config.material.curve;
    if (!curve.empty()) curve = beside(reader, curve);
    const double r = config.material.softening_r;
    base::require_input(r == 0 || r >= 1, reader.where(path + ".softening_r"), ": softening_r = ", r,
                        " is neither 0 (no softening) nor 1 or more");
    base::require_input(r == 0 || config.material.softening_m > 0, reader.where(path + ".softening_r"),
                        ": softening needs softening_m above zero");
    const auto& range = config.material.stability_range;
    base::require_input(range.size() == 2 && range[0] < 1 && range[1] > 1, reader.where(path + ".stability_range"),
                        ": stability_range needs two stretches, one below and one above 1");
}

void check_load(const LoadConfig& load, const base::ConfigReader& reader, const std::string& path, int dimension)
{
    if (load.kind == "spring") require_size(reader, load.stiffness, path + ".stiffness", dimension);
    if (load.kind == "nodal_force") require_size(reader, load.force, path + ".force", dimension);
    if (load.kind == "spring" || load.kind == "nodal_force") {
        base::require_input(load.group.empty() != load.position.empty(), reader.where(path), ": a ", load.kind,
                            " needs a group or a position, and not both");
        if (load.group.empty()) require_size(reader, load.position, path + ".position", dimension);
        return;
    }
    base::require_input(!load.group.empty(), reader.where(path), ": a ", load.kind, " needs the group it acts on");
    if (load.kind.ends_with("traction")) require_size(reader, load.traction, path + ".traction", dimension);
    base::require_input(load.kind != "pressure" || load.distribution == "uniform" || load.density > 0,
                        reader.where(path), ": a hydrostatic pressure needs density and level");
}

/// Each load has a name of its own.
void name_loads(SolidConfig& config, const base::ConfigReader& reader)
{
    std::set<std::string> names;
    for (std::size_t k = 0; k < config.loads.size(); ++k) {
        std::string& name = config.loads[k].name;
        if (name.empty()) name = "load" + std::to_string(k + 1);
        base::require_input(names.insert(name).second, reader.where(element("loads", k)), ": a load \"", name,
                            "\" exists already");
    }
}

void check_contact(ContactConfig& contact, const base::ConfigReader& reader, const std::string& path, int dimension)
{
    if (contact.point.empty()) contact.point.assign(static_cast<std::size_t>(dimension), 0.0);
    if (contact.normal.empty()) {
        contact.normal.assign(static_cast<std::size_t>(dimension), 0.0);
        contact.normal.back() = 1;
    }
    require_size(reader, contact.point, path + ".point", dimension);
    require_size(reader, contact.normal, path + ".normal", dimension);
    if (contact.ground != "table" && contact.ground != "surface") return;
    base::require_input(!contact.file.empty(), reader.where(path), ": ground = \"", contact.ground,
                        "\" needs file = \"", contact.ground == "surface" && dimension == 3 ? "FILE.stl" : "FILE.csv",
                        "\"");
    contact.file = beside(reader, contact.file);
}

void check_support(const SupportConfig& support, const base::ConfigReader& reader, const std::string& path,
                   int dimension)
{
    const bool moved = !support.ux.text.empty() || !support.uy.text.empty() || !support.uz.text.empty();
    base::require_input(moved || support.symmetry || !support.fix.empty(), reader.where(path),
                        ": a support needs fix = [\"x\", ...], symmetry = true or a displacement ux, uy");
    base::require_input(dimension == 3 || support.uz.text.empty(), support.uz.where, ": uz in a model of dimension 2");
    const auto fixed = [&](const char* axis) { return std::ranges::count(support.fix, axis) > 0; };
    base::require_input(!(fixed("x") && !support.ux.text.empty()) && !(fixed("y") && !support.uy.text.empty()) &&
                            !(fixed("z") && !support.uz.text.empty()),
                        reader.where(path), ": a component is fixed and has a displacement; give one of them");
}

void check_drive(const DriveConfig& drive, const base::ConfigReader& reader, const std::string& path, int dimension)
{
    require_size(reader, drive.centre, path + ".centre", dimension);
    base::require_input(dimension == 3 || drive.axis.empty(), reader.where(path + ".axis"),
                        ": in 2D a drive turns about z; leave the axis out");
    if (dimension == 2 || (drive.axis.empty() && drive.angle.text == "0")) return;
    require_size(reader, drive.axis, path + ".axis", dimension);
    base::require_input(drive.axis != std::vector<double>(3, 0.0), reader.where(path + ".axis"), ": the axis is zero");
}

void check_probes(const SolidConfig& config, const base::ConfigReader& reader)
{
    std::set<std::string> names;
    for (std::size_t k = 0; k < config.probes.size(); ++k) {
        const ProbeConfig& probe = config.probes[k];
        require_size(reader, probe.position, element("probes", k) + ".position", config.model.dimension);
        base::require_input(names.insert(probe.name).second, reader.where(element("probes", k)), ": a probe \"",
                            probe.name, "\" exists already");
    }
}

} // namespace

SolidConfig read_solid_config(base::ConfigReader& reader)
{
    SolidConfig config;
    config.model = reader.table("model", model_table());
    config.mesh = reader.table("mesh", mesh_table());
    const auto materials = reader.named_tables("material", material_table());
    config.gravity = reader.table("gravity", gravity_table());
    config.damping = reader.table("damping", damping_table());
    config.supports = reader.tables("supports", support_table());
    config.drives = reader.tables("drives", drive_table());
    config.loads = reader.tables("loads", load_table());
    config.contacts = reader.tables("contact", contact_table());
    config.interface = reader.table("interface", interface_table());
    config.analysis = reader.table("analysis", analysis_table());
    config.time = reader.table("time", time_table());
    config.initial = reader.table("initial", initial_table());
    config.newton = reader.table("newton", newton_table());
    config.linear_solver = reader.table("linear_solver", linear_solver_table());
    config.probes = reader.tables("probes", probe_table());
    config.output = reader.table("output", output_table());
    if (reader.describing()) return config;
    reader.finish();

    check_mesh(config, reader);
    check_material(config, reader, materials);
    if (config.gravity.acceleration.empty()) config.gravity.acceleration.assign(config.model.dimension, 0.0);
    require_size(reader, config.gravity.acceleration, "gravity.acceleration", config.model.dimension);
    if (config.initial.velocity.empty()) config.initial.velocity.assign(config.model.dimension, 0.0);
    require_size(reader, config.initial.velocity, "initial.velocity", config.model.dimension);
    name_loads(config, reader);
    for (std::size_t k = 0; k < config.loads.size(); ++k)
        check_load(config.loads[k], reader, element("loads", k), config.model.dimension);
    for (std::size_t k = 0; k < config.contacts.size(); ++k)
        check_contact(config.contacts[k], reader, element("contact", k), config.model.dimension);
    for (std::size_t k = 0; k < config.supports.size(); ++k)
        check_support(config.supports[k], reader, element("supports", k), config.model.dimension);
    for (std::size_t k = 0; k < config.drives.size(); ++k)
        check_drive(config.drives[k], reader, element("drives", k), config.model.dimension);
    check_probes(config, reader);
    return config;
}

} // namespace fem

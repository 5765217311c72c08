// SPDX-License-Identifier: MIT
#include "coupler_lib/session/coupling_config.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "coupler_lib/foundation/nearest_name.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

namespace coupler {
namespace {

base::Table<ParticipantConfig> participant_table()
{
    return base::Table<ParticipantConfig>("a program that takes part, under the name of its role")
        .key("program", &ParticipantConfig::program,
             {.doc = "what plays this role: an executable of the build or of your own (\"./plate\"), a Python script "
                     "(\"gate.py\"), both relative to this file, or a Python module (\"rivage.fake_solid\")",
              .required = true})
        .key("file", &ParticipantConfig::file,
             {.doc = "its own configuration, relative to this file; sph_solver and fem_solver need one"})
        .key("arguments", &ParticipantConfig::arguments, {.doc = "the program's own, before --as, --out and --set"});
}

base::Table<RunTimeConfig> time_table()
{
    return base::Table<RunTimeConfig>("duration of the coupled run")
        .key("end", &RunTimeConfig::end,
             {.unit = "s", .doc = "physical time at which the run ends", .positive = true, .required = true});
}

base::Table<RunOutputConfig> output_table()
{
    return base::Table<RunOutputConfig>("when both participants write; at the first step at or after the nominal time")
        .key("interval", &RunOutputConfig::interval,
             {.unit = "s", .doc = "between two field outputs; 0: start and end only", .min = 0})
        .key("table_interval", &RunOutputConfig::table_interval,
             {.unit = "s", .doc = "between two rows of the CSV tables; 0: every step", .min = 0});
}

base::Table<SchemeConfig> scheme_table()
{
    return base::Table<SchemeConfig>("how the two sides are coupled")
        .key("scheme", &SchemeConfig::scheme,
             {.doc =
                  "parallel: load lagged by a step; parallel_impedance: the same with the acoustic reaction of the wet "
                  "surface taken implicitly in the solid; parallel_extrapolated: the load carried on linearly in time; "
                  "serial: the solid steps after the fluid, with the load of the same interval, while the fluid waits",
              .choices = {"parallel", "parallel_impedance", "parallel_extrapolated", "serial"}})
        .key("impedance_factor", &SchemeConfig::impedance_factor,
             {.unit = "-", .doc = "share of rho c used by parallel_impedance", .min = 0, .max = 2})
        .key(
            "smoothing_steps", &SchemeConfig::smoothing_steps,
            {.unit = "-",
             .doc =
                 "parallel_impedance: steps over which the acceleration is averaged that the wall is known to have; 0: "
                 "not taken off, which adds mass",
             .min = 0,
             .max = 1000})
        .key("solid_every", &SchemeConfig::solid_every,
             {.unit = "-",
              .doc = "steps of the fluid, all of one length, for one of the solid, which gets their mean load; in "
                     "between the "
                     "wet surface goes on with its velocity and acceleration. For solids whose call is dear",
              .min = 1,
              .max = 1000})
        .key("acceleration", &SchemeConfig::acceleration,
             {.doc = "wall acceleration sent to the fluid: mean over the solid's last steps, or the nodal one",
              .choices = {"mean", "nodal"}})
        .key("acceleration_steps", &SchemeConfig::acceleration_steps,
             {.unit = "-", .doc = "steps that the mean acceleration spans", .min = 1, .max = 100})
        .key("handshake_timeout", &SchemeConfig::handshake_timeout,
             {.unit = "s", .doc = "longest wait for a participant to appear", .positive = true})
        .key("silence_timeout", &SchemeConfig::silence_timeout,
             {.unit = "s", .doc = "longest wait for a packet of the partner", .positive = true})
        .key(
            "wait", &SchemeConfig::wait,
            {.doc = "how to wait. auto: spin, then yield, then sleep; spin: keep the core; yield: give it away at once",
             .choices = {"auto", "spin", "yield"}})
        .key("record", &SchemeConfig::record,
             {.doc = "file in the output folder for every packet that crosses the interface, for --replay; each rank "
                     "writes its own, traffic.h5 becomes traffic.solid.fluid.0.h5. Empty: none"});
}

base::Table<InterfaceConfig> interface_table()
{
    return base::Table<InterfaceConfig>(
               "the wet surface that fluid and solid share; with several solids [[interface]] for each")
        .key("fluid", &InterfaceConfig::fluid, {.doc = "role of the fluid"})
        .key("solid", &InterfaceConfig::solid, {.doc = "role of the solid"})
        .key("surface", &InterfaceConfig::surface, {.doc = "name of the surface in messages"})
        .key("load", &InterfaceConfig::load,
             {.doc = "conservative: momentum exchanged with the wall; averaged: pressure of the particles beside each "
                     "facet",
              .choices = {"conservative", "averaged"}})
        .key("coverage_limit", &InterfaceConfig::coverage_limit,
             {.unit = "-", .doc = "averaged load: facets covered less than this get none", .min = 0, .max = 1})
        .key("motion_jump_limit", &InterfaceConfig::motion_jump_limit,
             {.unit = "facet sizes",
              .doc = "a wet node that moves farther within one step stops the run",
              .positive = true});
}

void check_role(const CouplingConfig& config, const std::string& key, const std::string& role,
                const base::ConfigReader& reader)
{
    const auto roles = config.roles();
    base::require_input(std::ranges::find(roles, role) != roles.end(), reader.where("interface." + key),
                        ": [interface] ", key, " = \"", role, "\" is no participant", base::suggestion(role, roles));
}

/// One fluid, each solid once, and nobody left over.
void check_interfaces(const CouplingConfig& config, const base::ConfigReader& reader)
{
    const std::string here = reader.where("interface");
    std::set<std::string> taken;
    for (const InterfaceConfig& one : config.interfaces) {
        check_role(config, "fluid", one.fluid, reader);
        check_role(config, "solid", one.solid, reader);
        base::require_input(one.fluid == config.interfaces.front().fluid, here,
                            ": the interfaces have different fluids, '", config.interfaces.front().fluid, "' and '",
                            one.fluid, "': a run has one");
        base::require_input(one.fluid != one.solid, here, ": '", one.fluid, "' is fluid and solid of one interface");
        base::require_input(
            taken.insert(one.solid).second, here, ": '", one.solid,
            "' has two interfaces: name all its wet groups in its own file, they make one interface, or "
            "give each a solid of its own with solid = \"...\"");
        taken.insert(one.fluid);
    }
    for (const std::string& role : config.roles())
        base::require_input(taken.count(role) > 0, here, ": the participant '", role,
                            "' has no interface: add [[interface]] with solid = \"", role, "\"");
}

} // namespace

std::string ParticipantConfig::command(const std::string& role, const std::string& shared_file) const
{
    const std::string beside = (std::filesystem::path(shared_file).parent_path() / program).string();
    std::string line = is_script() ? "/usr/bin/python3 " + beside : is_path() ? beside : program;
    if (is_module()) line = "/usr/bin/python3 -m " + program;
    line += " " + shared_file;
    for (const std::string& argument : arguments) line += " " + argument;
    return line + " --as " + role;
}

std::vector<std::string> CouplingConfig::roles() const
{
    std::vector<std::string> names;
    for (const auto& [name, participant] : participants) names.push_back(name);
    return names;
}

std::unique_ptr<LoadPrediction> SchemeConfig::load_prediction() const
{
    if (scheme == "parallel_extrapolated") return make_extrapolated_load();
    if (scheme == "parallel_impedance" && smoothing_steps > 0) return make_smoothed_reference(smoothing_steps);
    return make_lagged_load();
}

WaitStyle SchemeConfig::wait_style() const
{
    if (wait == "spin") return WaitStyle::spin;
    return wait == "yield" ? WaitStyle::yield : WaitStyle::automatic;
}

InterfaceSettings InterfaceConfig::settings(const std::string& role) const
{
    InterfaceSettings settings;
    settings.name = surface;
    settings.partner = role == fluid ? solid : fluid;
    settings.load = load_kind();
    settings.coverage_limit = coverage_limit;
    settings.motion_jump_limit = motion_jump_limit;
    return settings;
}

std::vector<InterfaceConfig> CouplingConfig::interfaces_of(const std::string& role) const
{
    std::vector<InterfaceConfig> mine;
    for (const InterfaceConfig& one : interfaces)
        if (one.fluid == role || one.solid == role) mine.push_back(one);
    return mine;
}

InterfaceConfig CouplingConfig::interface_of(const std::string& role) const
{
    const auto mine = interfaces_of(role);
    base::require_input(mine.size() == 1, "'", role, "' has ", mine.size(),
                        " interfaces, but this program serves one only");
    return mine.front();
}

CouplingConfig read_coupling_config(base::ConfigReader& reader)
{
    CouplingConfig config;
    config.participants = reader.named_tables("participants", participant_table());
    config.time = reader.table("time", time_table());
    config.output = reader.table("output", output_table());
    config.scheme = reader.table("coupling", scheme_table());
    config.interfaces = reader.one_or_more("interface", interface_table());
    reader.finish();
    if (reader.describing()) return config;
    base::require_input(config.participants.size() >= 2, reader.file_name(),
                        ": two participants are wanted, [participants.fluid] and "
                        "[participants.solid], not ",
                        config.participants.size());
    check_interfaces(config, reader);
    return config;
}

} // namespace coupler

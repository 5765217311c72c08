// SPDX-License-Identifier: MIT
#include "coupler_lib/session/command_line.hpp"

#include "coupler_lib/base/version.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <CLI/CLI.hpp>

namespace coupler {
namespace {

std::pair<std::string, std::string> split_override(const std::string& argument)
{
    const auto equals = argument.find('=');
    if (equals == std::string::npos || equals == 0)
        throw CLI::ValidationError("--set",
                                   "wants KEY=VALUE, such as fluid.resolution.spacing=0.002, not '" + argument + "'");
    return {argument.substr(0, equals), argument.substr(equals + 1)};
}

} // namespace

ParsedCommandLine parse_command_line(int argc, char** argv, const std::string& program, const std::string& purpose,
                                     std::string (*key_help)(const void* context), const void* context)
{
    ParsedCommandLine parsed;
    CommandLine& command = parsed.command;
    std::vector<std::string> overrides;
    bool show_version = false, show_keys = false;

    CLI::App app(purpose, program);
    app.add_option("file", command.file, "coupling.toml of a case, or the program's own file to run alone")
        ->type_name("FILE");
    app.add_option("--as", command.role, "name of the role to play, as in [participants.NAME]")->type_name("NAME");
    app.add_option("--out", command.output_dir, "folder for the results (default runs/<case>)")->type_name("DIR");
    app.add_option("--set", overrides, "override a key: coupling.time.end=0.1, fluid.resolution.spacing=0.002")
        ->type_name("KEY=VALUE");
    app.add_flag("--check", command.check_only,
                 "check all files and the data flow between the participants, then stop");
    app.add_option("--replay", command.replay,
                   "run without the partner, on what a run with coupling.record = \"traffic.h5\" wrote of it")
        ->type_name("traffic.h5");
    app.add_flag("--describe", command.describe, "with --check: print what this participant sends and needs")
        ->group("");
    app.add_flag("--help-config", show_keys, "every key: type, unit, default, range, meaning");
    app.add_flag("--version", show_version, "version, commit, compiler and libraries");
    try {
        app.parse(argc, argv);
        for (const auto& argument : overrides) command.overrides.push_back(split_override(argument));
        if (!show_version && !show_keys && command.file.empty()) throw CLI::RequiredError("a configuration file: FILE");
    } catch (const CLI::CallForHelp&) {
        return {command, true, 0, app.help()};
    } catch (const CLI::ParseError& error) {
        return {command, true, static_cast<int>(base::ExitCode::bad_input),
                program + ": " + error.what() + "\nRun '" + program + " --help' for what it takes.\n"};
    }
    if (show_version) return {command, true, 0, program + ", part of " + base::version_details()};
    if (show_keys) return {command, true, 0, key_help(context)};
    return parsed;
}

} // namespace coupler

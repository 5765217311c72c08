// SPDX-License-Identifier: MIT
#include "coupler_lib/base/version.hpp"
#include "coupler_lib/coupling/mpi_session.hpp"
#include "coupler_lib/recorder/traffic_file.hpp"
#include "coupler_lib/session/session.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <new>

namespace coupler {
namespace {

std::string describe_keys(const void* context)
{
    const auto& program = *static_cast<const ProgramInfo*>(context);
    auto own = base::ConfigReader::describe();
    program.read_own_file(own);
    auto shared = base::ConfigReader::describe();
    read_coupling_config(shared);
    return fmt::format("# {}: its own file\n\n{}# the shared file, coupling.toml\n\n{}", program.name, own.help(),
                       shared.help());
}

std::vector<LaunchSegment> launch_segments(const RunFiles& files)
{
    std::vector<LaunchSegment> segments;
    if (!files.coupling) return segments;
    for (const auto& [role, participant] : files.coupling->participants)
        segments.push_back({role, participant.command(role, files.coupling_file)});
    return segments;
}

/// What can be known before MPI starts; an error is kept, so that the handshake ends all ranks with it.
struct Preparation {
    RunFiles files;
    ParticipantSettings settings;
};

/// Over MPI alone, with a recording beside it, or from a recording that stands for the partner.
void choose_couriers(const CommandLine& command, Preparation& made)
{
    ParticipantSettings& settings = made.settings;
    if (command.replay.empty()) {
        const std::string& record = made.files.coupling->scheme.record;
        if (!record.empty())
            settings.couriers =
                recording_couriers(made.files.output_dir + "/" + record, {.role = settings.role,
                                                                          .partner = {},
                                                                          .config_hash = settings.config_hash,
                                                                          .git_hash = settings.version});
        return;
    }
    for (const InterfaceConfig& interface : made.files.coupling->interfaces_of(settings.role)) {
        const std::string partner = interface.settings(settings.role).partner;
        const std::string path = traffic_path(command.replay, settings.role, partner, 0);
        const TrafficInfo then = TrafficReader(path).info();
        base::require_input(then.role == settings.role && then.partner == partner, "'", path,
                            "' holds the traffic of '", then.role, "' with '", then.partner, "', not of '",
                            settings.role, "' with '", partner, "'");
        settings.recorded[partner] = then.partner_ranks;
    }
    settings.expected_roles = {settings.role};
    made.files.replay = std::make_shared<ReplayVerdict>();
    settings.couriers = replaying_couriers(command.replay, made.files.replay);
}

Preparation prepare(const ProgramInfo& program, const CommandLine& command)
{
    Preparation made;
    auto& settings = made.settings;
    settings.role = command.role.empty() ? program.default_role : command.role;
    settings.config_file = command.file;
    settings.program = program.name;
    settings.version = base::git_hash();
    settings.libraries = base::parallel_libraries();
    try {
        made.files = read_run_files(program, command);
        settings.config_hash = made.files.config_hash;
        settings.own_file = made.files.own_file;
        settings.own_hash = made.files.own_hash;
        settings.launch = launch_segments(made.files);
        settings.expected_roles =
            made.files.coupling ? made.files.coupling->roles() : std::vector<std::string>{settings.role};
        if (made.files.coupling) {
            settings.handshake_timeout = made.files.coupling->scheme.handshake_timeout;
            settings.silence_timeout = made.files.coupling->scheme.silence_timeout;
            settings.wait = made.files.coupling->scheme.wait_style();
        }
        if (made.files.coupling) choose_couriers(command, made);
        if (made.files.coupling && command.check_only && started_alone()) {
            settings.expected_roles = {settings.role};
            made.files.describe = command.describe;
            if (!command.describe)
                made.files.partners = describe_partners(*made.files.coupling, command, settings.role);
        }
        base::require_input(command.replay.empty() || made.files.coupling, "--replay needs coupling.toml, not '",
                            command.file, "'");
    } catch (const base::Error& error) {
        settings.failure = error.what();
        settings.failure_code = error.code();
    }
    return made;
}

/// Runs `body` and turns whatever it throws into the end of the whole run.
int run_body(Participant& participant, const Preparation& prepared, bool check_only,
             const std::function<void(Session&)>& body)
{
    try {
        Session session(participant, prepared.files, check_only);
        body(session);
        participant.finish();
        participant.await_farewells();
        return participant.stop_requested() ? static_cast<int>(base::ExitCode::stopped_on_request) : 0;
    } catch (const base::Error& error) {
        participant.report_failure(error);
        return static_cast<int>(error.code());
    } catch (const std::bad_alloc&) {
        participant.report_failure(
            {base::ExitCode::numerical_failure, "out of memory; use more ranks or a coarser resolution"});
    } catch (const std::exception& error) {
        participant.report_failure({base::ExitCode::numerical_failure, error.what()});
    }
    return static_cast<int>(base::ExitCode::numerical_failure);
}

} // namespace

int run_program(const ProgramInfo& program, int argc, char** argv, const std::function<void(Session&)>& body)
{
    const auto parsed = parse_command_line(argc, argv, program.name, program.purpose, &describe_keys, &program);
    if (parsed.leave) {
        std::fputs(parsed.text.c_str(), parsed.code == 0 ? stdout : stderr);
        return parsed.code;
    }
    const Preparation prepared = prepare(program, parsed.command);
    const MpiSession mpi(argc, argv, prepared.settings.role, prepared.settings.handshake_timeout,
                         launch_line(prepared.settings.launch));
    try {
        Participant participant(prepared.settings);
        return run_body(participant, prepared, parsed.command.check_only, body);
    } catch (const AgreedError& error) {
        return static_cast<int>(error.code());
    }
}

} // namespace coupler

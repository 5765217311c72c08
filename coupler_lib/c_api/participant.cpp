// SPDX-License-Identifier: MIT
#include "coupler_lib/base/version.hpp"
#include "coupler_lib/c_api/handles.hpp"
#include "coupler_lib/coupling/mpi_session.hpp"

namespace coupler::c_api {
namespace {

thread_local std::string last_error;
std::unique_ptr<MpiSession> mpi; ///< where rivage_mpi_start made MPI_Init

/// What follows the file in the command line of a program from outside.
struct Arguments {
    std::string role, output_dir;
    std::vector<std::pair<std::string, std::string>> overrides;

    void add_override(const std::string& text)
    {
        const std::size_t equals = text.find('=');
        base::require_input(equals != std::string::npos && text[0] != '-', "'", text,
                            "' is no argument: KEY=VALUE, --set KEY=VALUE, --as ROLE and --out FOLDER are known");
        overrides.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
};

Arguments read_arguments(const std::vector<std::string>& words)
{
    Arguments found;
    for (std::size_t k = 0; k < words.size(); ++k) {
        const std::string& word = words[k];
        const bool option = word == "--set" || word == "--as" || word == "--out";
        base::require_input(!option || k + 1 < words.size(), "a value is missing after '", word, "'");
        if (word == "--as")
            found.role = words[++k];
        else if (word == "--out")
            found.output_dir = words[++k];
        else
            found.add_override(option ? words[++k] : word);
    }
    return found;
}

ParticipantSettings settings_of(MPI_Comm world, const std::string& role, const std::string& file,
                                const SharedFile& shared)
{
    ParticipantSettings settings;
    settings.world = world;
    settings.role = role;
    settings.expected_roles = shared.config.roles();
    settings.config_file = file;
    settings.config_hash = shared.hash;
    settings.version = base::git_hash();
    settings.handshake_timeout = shared.config.scheme.handshake_timeout;
    settings.silence_timeout = shared.config.scheme.silence_timeout;
    settings.wait = shared.config.scheme.wait_style();
    return settings;
}

/// Reads the files and joins; a file that cannot be used ends all ranks with its message.
rivage_participant* join(MPI_Comm world, std::string role, const std::string& file,
                         const std::vector<std::string>& words)
{
    SharedFile shared;
    Arguments arguments;
    ParticipantSettings settings;
    settings.world = world;
    settings.role = role;
    try {
        arguments = read_arguments(words);
        if (!arguments.role.empty()) role = arguments.role;
        shared = read_shared_file(file, role, arguments.overrides);
        settings = settings_of(world, role, file, shared);
    } catch (const base::Error& error) {
        settings.failure = error.what();
        settings.failure_code = error.code();
    }
    auto* joined = new rivage_participant(settings, shared.config);
    joined->output_dir = arguments.output_dir;
    return joined;
}

} // namespace

int remember(int code, const std::string& message)
{
    last_error = message;
    return code;
}

} // namespace coupler::c_api

using namespace coupler;

const char* rivage_last_error(void) { return c_api::last_error.c_str(); }

const char* rivage_version(void)
{
    static const std::string version = base::version();
    return version.c_str();
}

int rivage_mpi_start(const char* role, double timeout)
{
    return c_api::guarded([&] {
        int running = 0;
        MPI_Initialized(&running);
        int argc = 0;
        char** argv = nullptr;
        if (!running) c_api::mpi = std::make_unique<MpiSession>(argc, argv, role, timeout);
    });
}

int rivage_mpi_end(void)
{
    return c_api::guarded([] { c_api::mpi.reset(); });
}

int rivage_world(void) { return MPI_Comm_c2f(MPI_COMM_WORLD); }

int rivage_join(int world, const char* role, const char* coupling_file, const char* const* arguments,
                int argument_count, rivage_participant** participant)
{
    return c_api::guarded([&] {
        *participant = c_api::join(MPI_Comm_f2c(world), role, coupling_file, {arguments, arguments + argument_count});
    });
}

int rivage_leave(rivage_participant* participant)
{
    const int code = c_api::guarded([&] {
        participant->member.finish();
        participant->member.await_farewells();
    });
    const bool stopped = participant->member.stop_requested();
    delete participant;
    return code == RIVAGE_OK && stopped ? c_api::remember(RIVAGE_STOPPED, "stopped on request") : code;
}

void rivage_fail(rivage_participant* participant, int code, const char* message)
{
    participant->member.report_failure({static_cast<base::ExitCode>(code), message});
}

int rivage_comm(const rivage_participant* participant) { return MPI_Comm_c2f(participant->member.comm().handle()); }
const char* rivage_role(const rivage_participant* participant) { return participant->member.role().c_str(); }
const char* rivage_output_dir(const rivage_participant* participant) { return participant->output_dir.c_str(); }
int rivage_rank(const rivage_participant* participant) { return participant->member.comm().rank(); }
int rivage_size(const rivage_participant* participant) { return participant->member.comm().size(); }
double rivage_end_time(const rivage_participant* participant) { return participant->config.time.end; }
double rivage_table_interval(const rivage_participant* participant)
{
    return participant->config.output.table_interval;
}
int rivage_is_serial(const rivage_participant* participant) { return participant->config.scheme.serial(); }
double rivage_impedance_share(const rivage_participant* participant)
{
    return participant->config.scheme.impedance_share();
}
int rivage_solid_every(const rivage_participant* participant) { return participant->config.scheme.solid_every; }
int rivage_stop_requested(const rivage_participant* participant) { return participant->member.stop_requested(); }
void rivage_request_stop(rivage_participant* participant) { participant->member.request_stop(); }

// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/json.hpp"
#include "coupler_lib/base/log.hpp"
#include "coupler_lib/base/timer.hpp"
#include "coupler_lib/coupling/participant.hpp"
#include "coupler_lib/recorder/recorder.hpp"
#include "coupler_lib/session/command_line.hpp"
#include "coupler_lib/session/coupling_config.hpp"
#include "coupler_lib/session/partner_description.hpp"
#include "coupler_lib/session/wait_balance.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace coupler {

/// What a program is and how it reads its own file.
struct ProgramInfo {
    std::string name;         ///< "sph_solver"
    std::string default_role; ///< "fluid"
    std::string purpose;      ///< one sentence for --help
    /// Reads (and so checks) every table of the program's own file; also called to describe them for --help-config.
    std::function<void(base::ConfigReader&)> read_own_file;
};

/// All files of a run as this participant reads them, overrides applied.
struct RunFiles {
    std::string role;
    std::optional<CouplingConfig> coupling; ///< absent when the program runs alone
    base::ConfigDocument own;
    std::string coupling_file; ///< path, or of the own file when alone
    std::string case_dir;      ///< folder of the file given on the command line
    std::string output_dir;
    std::string config_hash;                  ///< of the shared file and all overrides
    std::string own_file;                     ///< path
    std::string own_hash;                     ///< of its content
    bool describe = false;                    ///< --describe
    std::vector<PartnerDescription> partners; ///< of a check without mpirun
    std::string used_coupling;                ///< coupling.toml with its defaults, as TOML
    std::string used_own;                     ///< the own file likewise
    std::shared_ptr<ReplayVerdict> replay;    ///< of a run with --replay; else null
};

/// The shared file with its overrides, and the hash of both.
struct SharedFile {
    CouplingConfig config;
    std::string hash;
};

/// Reads coupling.toml for a role whose own file is its own matter: a solver from outside. Throws Error(bad_input).
SharedFile read_shared_file(const std::string& path, const std::string& role,
                            const std::vector<std::pair<std::string, std::string>>& overrides);

/// Reads everything, checks every key. Throws Error(bad_input) with file, line, column.
RunFiles read_run_files(const ProgramInfo& program, const CommandLine& command);

/// One participant's run: its place among the others, its files, its output folder, its log and timers.
class Session {
public:
    Session(Participant& participant, const RunFiles& files, bool check_only);

    Participant& participant() { return *participant_; }
    const base::Communicator& comm() const { return participant_->comm(); }
    bool is_root() const { return comm().is_root(); }
    /// Coupled to a partner, with a coupling() that says how.
    bool coupled() const { return files_.coupling.has_value(); }
    const CouplingConfig& coupling() const { return *files_.coupling; }
    /// Reader of the program's own file, overrides applied.
    base::ConfigReader reader() const { return base::ConfigReader(files_.own); }

    const std::string& role() const { return files_.role; }
    /// Folder of the case, to resolve relative paths.
    const std::string& case_dir() const { return files_.case_dir; }
    const std::string& output_dir() const { return files_.output_dir; }
    /// This participant's part of the output folder; exists.
    std::string own_dir() const { return files_.output_dir + "/" + own_folder_; }
    bool check_only() const { return check_only_; }
    const base::Log& log() const { return log_; }
    base::TimerTree& timers() { return timers_; }
    double wall_seconds() const { return watch_.seconds(); }

    /// For --check, on every rank of the participant: compares what the participants tell about themselves and logs it.
    /// Throws Error(bad_input) on world rank 0 when they do not fit together. \param mine  the role is filled in here
    void check_flow(DataFlow mine);

    /// Collective over the participant: adds the run's common figures, then writes DIR/<role>/summary.json; the
    /// participant that owns the first rank also gathers them all in DIR/summary.json. Call once, at the end.
    void write_summary(base::JsonObject own_figures);

private:
    void write_used_config();
    void report_replay(base::JsonObject& figures) const;
    std::string wait_balance(const WaitShare& mine);

    Participant* participant_;
    RunFiles files_;
    bool check_only_;
    std::string own_folder_;
    base::Log log_;
    base::TimerTree timers_;
    base::Stopwatch watch_;
};

/// The life of a program: command line, files, MPI, handshake, `body`, and the end in order or by the error's rules.
/// \return the exit code for main.
int run_program(const ProgramInfo& program, int argc, char** argv, const std::function<void(Session&)>& body);

} // namespace coupler

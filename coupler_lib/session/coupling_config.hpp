// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/config.hpp"
#include "coupler_lib/coupling/load_prediction.hpp"
#include "coupler_lib/coupling/patience.hpp"
#include "coupler_lib/coupling/surface.hpp"

#include <string>
#include <utility>
#include <vector>

namespace coupler {

/// [participants.NAME]
struct ParticipantConfig {
    std::string program, file;
    std::vector<std::string> arguments;

    bool is_script() const { return program.ends_with(".py"); }
    /// An executable beside the shared file, "./plate"; a name alone is one of the build.
    bool is_path() const { return !is_script() && program.find('/') != std::string::npos; }
    /// A Python module, "rivage.fake_solid".
    bool is_module() const { return !is_script() && !is_path() && program.find('.') != std::string::npos; }
    bool is_from_outside() const { return is_script() || is_path() || is_module(); }
    /// As one would type it, without the overrides. \param shared_file path of coupling.toml
    std::string command(const std::string& role, const std::string& shared_file) const;
};

/// [time]: of the whole coupled run.
struct RunTimeConfig {
    double end = 0;
};

/// [output]: both participants write at the same windows.
struct RunOutputConfig {
    double interval = 0;
    double table_interval = 0;
};

/// [coupling]: the scheme and how long to wait.
struct SchemeConfig {
    std::string scheme = "parallel_impedance";
    double impedance_factor = 0.5;
    int smoothing_steps = 20;
    int solid_every = 1;
    std::string acceleration = "mean";
    int acceleration_steps = 5;
    double handshake_timeout = 30;
    double silence_timeout = 300;
    std::string wait = "auto";
    std::string record;

    WaitStyle wait_style() const;
    /// The solid steps over an interval after the fluid, with the load of the same interval; else both at the same time.
    bool serial() const { return scheme == "serial"; }
    /// Share of rho c that the solid answers to within its step.
    double impedance_share() const { return scheme == "parallel_impedance" ? impedance_factor : 0; }
    /// What the solid makes of the loads.
    std::unique_ptr<LoadPrediction> load_prediction() const;
};

/// [interface], or [[interface]] once for each solid
struct InterfaceConfig {
    std::string fluid = "fluid", solid = "solid", surface = "wet";
    std::string load = "conservative";
    double coverage_limit = 0.3;
    double motion_jump_limit = 1.0;

    LoadKind load_kind() const { return load == "averaged" ? LoadKind::averaged : LoadKind::conservative; }
    /// As `coupling` takes them on the side of `role`; the fluid adds its impedance and limits.
    InterfaceSettings settings(const std::string& role) const;
};

/// coupling.toml: what both participants must agree on.
struct CouplingConfig {
    std::vector<std::pair<std::string, ParticipantConfig>> participants;
    RunTimeConfig time;
    RunOutputConfig output;
    SchemeConfig scheme;
    std::vector<InterfaceConfig> interfaces; ///< of one fluid, each with a solid of its own

    std::vector<std::string> roles() const;
    /// The interfaces that a role takes part in.
    std::vector<InterfaceConfig> interfaces_of(const std::string& role) const;
    /// The only one that it takes part in. Throws base::Error(bad_input) when there are several.
    InterfaceConfig interface_of(const std::string& role) const;
};

/// Reads all tables of coupling.toml. Throws Error(bad_input) with the place of what is wrong.
CouplingConfig read_coupling_config(base::ConfigReader& reader);

} // namespace coupler

// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/config/analysis_config.hpp"
#include "fem_solver/config/body_config.hpp"
#include "fem_solver/config/contact_config.hpp"
#include "fem_solver/config/load_config.hpp"

namespace fem {

/// All of solid.toml.
struct SolidConfig {
    ModelConfig model;
    MeshConfig mesh;
    MaterialConfig material;
    std::string material_name;
    GravityConfig gravity;
    DampingConfig damping;
    std::vector<SupportConfig> supports;
    std::vector<DriveConfig> drives;
    std::vector<LoadConfig> loads;
    std::vector<ContactConfig> contacts;
    InterfaceConfig interface;
    AnalysisConfig analysis;
    TimeConfig time;
    InitialConfig initial;
    NewtonConfig newton;
    LinearSolverConfig linear_solver;
    std::vector<ProbeConfig> probes;
    OutputConfig output;
};

/// Reads solid.toml and checks what one table alone cannot know.
/// \throws base::Error bad_input with file, line and column.
SolidConfig read_solid_config(base::ConfigReader& reader);

} // namespace fem

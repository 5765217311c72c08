// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/config.hpp"

#include <string>
#include <vector>

namespace fem {

/// [analysis]
struct AnalysisConfig {
    std::string kind = "dynamic";
    int load_steps = 4;
    bool initial_equilibrium = false;
    int modes = 6;
};

/// [time]
struct TimeConfig {
    std::string scheme = "hht";
    double alpha = -0.05;
    double dt = 0;
    double end = 0;
    int sub_steps = 1;
};

/// [initial]: the motion at the start.
struct InitialConfig {
    std::vector<double> velocity;
};

/// [newton]
struct NewtonConfig {
    double tolerance = 1e-9;
    int max_iterations = 25;
    double contraction = 0.1;
    std::string predictor = "constant_acceleration";
};

/// [linear_solver]
struct LinearSolverConfig {
    std::string method = "automatic";
    double tolerance = 1e-12;
    std::string options;
};

/// [[probes]]
struct ProbeConfig {
    std::string name;
    std::vector<double> position;
    std::vector<std::string> quantities = {"displacement"};
};

/// [output]: for a run alone; coupling.toml decides in a coupled one.
struct OutputConfig {
    double interval = 0;
    double table_interval = 0;
};

base::Table<AnalysisConfig> analysis_table();
base::Table<TimeConfig> time_table();
base::Table<InitialConfig> initial_table();
base::Table<NewtonConfig> newton_table();
base::Table<LinearSolverConfig> linear_solver_table();
base::Table<ProbeConfig> probe_table();
base::Table<OutputConfig> output_table();

} // namespace fem

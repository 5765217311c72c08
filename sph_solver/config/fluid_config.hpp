// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/config/method_config.hpp"
#include "sph_solver/config/output_config.hpp"
#include "sph_solver/config/wall_config.hpp"
#include "sph_solver/config/water_config.hpp"

#include <vector>

namespace sph {

/// All of fluid.toml.
struct FluidConfig {
    DomainConfig domain;
    TimeConfig time;
    ResolutionConfig resolution;
    LiquidConfig liquid;
    NumericsConfig numerics;
    ParallelConfig parallel;
    InitialConfig initial;
    OutputConfig output;
    std::vector<WaterConfig> water;
    std::vector<WallConfig> walls;
    std::vector<OutflowConfig> outflows;
    std::vector<ProbeConfig> probes;
};

/// Reads fluid.toml and checks each table for itself; in describe mode only records the tables.
/// Throws Error(bad_input) with file, line and column. What must fit together across tables is checked by the setup.
FluidConfig read_fluid_config(base::ConfigReader& reader);

} // namespace sph

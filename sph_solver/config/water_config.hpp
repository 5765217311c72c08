// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/config.hpp"
#include "coupler_lib/base/expression.hpp"

#include <limits>
#include <string>
#include <vector>

namespace sph {

/// [[water]]: one body of water at the start.
struct WaterConfig {
    std::string shape = "box";
    std::vector<double> low = {};
    std::vector<double> high = {};
    std::vector<double> centre = {};
    double radius = 0.0;
    std::vector<std::vector<double>> points = {};
    std::string file = {};
    double scale = 1.0;
    std::string group = "/";
    std::vector<base::Formula> velocity = {};
    double level = std::numeric_limits<double>::infinity();
};

/// [initial]
struct InitialConfig {
    std::string state = "hydrostatic";
    double level = std::numeric_limits<double>::infinity();
    base::Formula pressure = {"0", ""};
};

/// [[outflow]]: particles beyond a plane are taken out and counted.
struct OutflowConfig {
    std::string name = {};
    std::vector<double> point = {};
    std::vector<double> normal = {};
};

base::Table<WaterConfig> water_table();
base::Table<InitialConfig> initial_table();
base::Table<OutflowConfig> outflow_table();

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/config.hpp"

#include <string>
#include <vector>

namespace fem {

/// [[supports]]: displacements held at zero.
struct SupportConfig {
    std::string group;
    std::vector<std::string> fix;
};

/// [[loads]]
struct LoadConfig {
    std::string kind;
    std::string group;
    double pressure = 0;
    std::string distribution = "uniform";
    double density = 0;
    double level = 0;
    double gravity = 9.81;
    bool follower = true;
    std::vector<double> traction, position, force;
};

/// [interface]: where the fluid may touch the solid.
struct InterfaceConfig {
    std::vector<std::string> groups;
    int smoothing_steps = 20;
};

base::Table<SupportConfig> support_table();
base::Table<LoadConfig> load_table();
base::Table<InterfaceConfig> interface_table();

} // namespace fem

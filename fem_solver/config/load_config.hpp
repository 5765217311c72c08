// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/config.hpp"
#include "coupler_lib/base/expression.hpp"

#include <string>
#include <vector>

namespace fem {

/// [[supports]]: displacements held at zero or on a path.
struct SupportConfig {
    std::string group;
    std::vector<std::string> fix;
    bool symmetry = false;
    base::Formula ux, uy, uz;
    double derivative_step = 1e-4;
};

/// [[drives]]: groups moved as rigid bodies.
struct DriveConfig {
    std::string group;
    std::vector<double> centre, axis;
    base::Formula x{"0"}, y{"0"}, z{"0"}, angle{"0"};
    double derivative_step = 1e-4;
};

/// [[loads]]
struct LoadConfig {
    std::string name;
    std::string kind;
    std::string group;
    base::Formula factor{"1"};
    base::Formula pressure{"0"};
    std::string distribution = "uniform";
    double density = 0;
    double level = 0;
    double gravity = 9.81;
    bool follower = true;
    std::vector<double> traction, position, force, stiffness;
};

/// [interface]: where the fluid may touch the solid.
struct InterfaceConfig {
    std::vector<std::string> groups;
};

base::Table<SupportConfig> support_table();
base::Table<DriveConfig> drive_table();
base::Table<LoadConfig> load_table();
base::Table<InterfaceConfig> interface_table();

} // namespace fem

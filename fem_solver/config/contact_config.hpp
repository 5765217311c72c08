// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/config.hpp"
#include "coupler_lib/base/expression.hpp"

#include <string>
#include <vector>

namespace fem {

/// [[contact]]: a group of faces and the rigid ground that it may touch.
struct ContactConfig {
    std::string group;
    std::string ground = "plane";
    std::vector<double> point, normal; // plane
    base::Formula height{"0"};         // formula
    double derivative_step = 1e-5;     // formula
    std::string file;                  // table, surface
    double scale = 1;                  // surface
    base::Formula ux{"0"}, uy{"0"}, uz{"0"};
    double friction = 0;
    std::string formulation = "automatic";
    double penalty_factor = 10;
    double stick_factor = 1;
    double tolerance = 1e-4;
    int max_augmentations = 50;
};

base::Table<ContactConfig> contact_table();

} // namespace fem

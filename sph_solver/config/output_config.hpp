// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/config.hpp"

#include <string>
#include <vector>

namespace sph {

/// [output]
struct OutputConfig {
    double interval = 0.0;
    double table_interval = 0.0;
};

/// [[probes]]: one quantity followed over time, a column (or one a component) of probes.csv.
struct ProbeConfig {
    std::string name = {};
    std::string quantity = "pressure";
    std::vector<double> point = {};
    std::vector<double> low = {};
    std::vector<double> high = {};
    std::string axis = "x";
    double size = 0.0;
};

base::Table<OutputConfig> output_table();
base::Table<ProbeConfig> probe_table();

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/config.hpp"

#include <string>
#include <vector>

namespace fem {

/// [model]: what kind of solid is computed.
struct ModelConfig {
    int dimension = 2;
    std::string assumption = "plane_strain";
};

/// [mesh]: a built-in block or a MED file.
struct MeshConfig {
    std::string kind = "block";
    std::vector<double> low, high, cells; // block
    std::string element = "quad8";        // block
    std::string file, name;               // med
    double scale = 1;                     // med
    std::string integration = "reduced";
    std::string formulation = "automatic";
};

/// [material.NAME]
struct MaterialConfig {
    std::string law = "elastic";
    double young = 0;
    double poisson = 0;
    double density = 0;
    std::string kinematics = "finite";
    std::string volumetric = "quadratic";  // neo_hookean
    double c10 = 0, c01 = 0;               // mooney_rivlin
    std::vector<double> moduli, exponents; // ogden
    std::string curve;                     // marlow
    double softening_r = 0, softening_m = 0, softening_beta = 0;
    std::vector<double> stability_range = {0.5, 2};
};

/// [gravity]
struct GravityConfig {
    std::vector<double> acceleration;
};

/// [damping]
struct DampingConfig {
    double stiffness = 0;
    double mass = 0;
};

base::Table<ModelConfig> model_table();
base::Table<MeshConfig> mesh_table();
base::Table<MaterialConfig> material_table();
base::Table<GravityConfig> gravity_table();
base::Table<DampingConfig> damping_table();

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/config.hpp"

#include <string>
#include <vector>

namespace sph {

/// [domain]
struct DomainConfig {
    int dimension = 2;
    std::vector<double> gravity; ///< as many numbers as dimensions; none: no gravity
};

/// [time]
struct TimeConfig {
    double start = 0.0;
    double end = 0.0;
    double cfl = 0.6;
    double fixed_dt = 0.0;
};

/// [resolution]
struct ResolutionConfig {
    double spacing = 0.0;
    double smoothing_ratio = 1.23;
    double skin = 0.15;

    [[nodiscard]] double smoothing_length() const { return smoothing_ratio * spacing; }
};

/// [fluid]
struct LiquidConfig {
    double density = 1000.0;
    double sound_speed = 0.0;
    double viscosity = 0.0;
};

/// [numerics]
struct NumericsConfig {
    std::string limiter = "van_albada";
    std::string riemann = "exact";
    std::string face_motion = "mean";
    double shift_strength = 100.0;
    std::string pair_area = "renormalised";
    std::string integrator = "rk2";
    double trap_gap = 0.0;
};

/// [parallel]
struct ParallelConfig {
    double imbalance_limit = 1.08;
    int rebuilds_between = 20;
};

base::Table<DomainConfig> domain_table();
base::Table<TimeConfig> time_table();
base::Table<ResolutionConfig> resolution_table();
base::Table<LiquidConfig> liquid_table();
base::Table<NumericsConfig> numerics_table();
base::Table<ParallelConfig> parallel_table();

} // namespace sph

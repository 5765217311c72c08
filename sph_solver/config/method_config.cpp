// SPDX-License-Identifier: MIT
#include "sph_solver/config/method_config.hpp"

namespace sph {

base::Table<DomainConfig> domain_table()
{
    return base::Table<DomainConfig>("space and gravity")
        .key("dimension", &DomainConfig::dimension,
             {.unit = "-", .doc = "2 (per metre of depth) or 3", .min = 2, .max = 3})
        .key("gravity", &DomainConfig::gravity,
             {.unit = "m/s^2", .doc = "gravity vector, one number a dimension; none: no gravity"});
}

base::Table<TimeConfig> time_table()
{
    return base::Table<TimeConfig>("physical time and time step; a coupled run takes its end from coupling.toml")
        .key("start", &TimeConfig::start, {.unit = "s", .doc = "time of the initial state"})
        .key("end", &TimeConfig::end,
             {.unit = "s", .doc = "end of the run, needed when the fluid runs alone", .min = 0})
        .key("cfl", &TimeConfig::cfl,
             {.unit = "-",
              .doc = "dt is about cfl h / c, on a ladder of steps; clean up to 0.7 with rk2, 0.9 "
                     "with rk3, 1 with rk4, 1.6 with hybrid3",
              .max = 2.0,
              .positive = true})
        .key("fixed_dt", &TimeConfig::fixed_dt,
             {.unit = "s", .doc = "constant time step instead of the CFL rule; 0: the CFL rule", .min = 0});
}

base::Table<ResolutionConfig> resolution_table()
{
    return base::Table<ResolutionConfig>("particle size")
        .key("spacing", &ResolutionConfig::spacing,
             {.unit = "m", .doc = "initial particle spacing dx", .positive = true, .required = true})
        .key("smoothing_ratio", &ResolutionConfig::smoothing_ratio,
             {.unit = "-", .doc = "smoothing length h over dx", .min = 1.0, .max = 2.0})
        .key("skin", &ResolutionConfig::skin,
             {.unit = "-", .doc = "what neighbour lists reach beyond 2 h, over 2 h; speed only", .min = 0, .max = 1.0});
}

base::Table<LiquidConfig> liquid_table()
{
    return base::Table<LiquidConfig>("the liquid: p = (rho0 c0^2 / 7) ((rho / rho0)^7 - 1)")
        .key("density", &LiquidConfig::density, {.unit = "kg/m^3", .doc = "reference density rho0", .positive = true})
        .key("sound_speed", &LiquidConfig::sound_speed,
             {.unit = "m/s",
              .doc = "numerical speed of sound c0 at rho0, about 10 times the largest speed expected",
              .positive = true,
              .required = true})
        .key("viscosity", &LiquidConfig::viscosity,
             {.unit = "Pa s", .doc = "dynamic viscosity, laminar; 0: inviscid. Water 1e-3, a light oil 0.1", .min = 0});
}

base::Table<NumericsConfig> numerics_table()
{
    return base::Table<NumericsConfig>("the method")
        .key("limiter", &NumericsConfig::limiter,
             {.doc = "MUSCL slope limiter; van_leer: less dissipation, more noise; none: unlimited slopes; "
                     "first_order: no slopes",
              .choices = {"van_albada", "van_leer", "none", "first_order"}})
        .key("riemann", &NumericsConfig::riemann,
             {.doc = "Riemann solver; two_rarefaction: without shocks; acoustic: linear, not for violent flow",
              .choices = {"exact", "two_rarefaction", "acoustic"}})
        .key("face_motion", &NumericsConfig::face_motion,
             {.doc = "faces between particles move with the pair's mean velocity, and mass is exchanged; or with the "
                     "fluid: "
                     "each particle keeps its mass; shifted: with the mean of particles that even out their distances",
              .choices = {"mean", "fluid", "shifted"}})
        .key("shift_strength", &NumericsConfig::shift_strength,
             {.unit = "-",
              .doc = "how fast shifted particles even out, times the rate of strain",
              .min = 0,
              .max = 1000})
        .key("pair_area", &NumericsConfig::pair_area,
             {.doc = "area vectors of the faces: the kernel's raw gradients, or renormalised inside the water",
              .choices = {"raw", "renormalised"}})
        .key("integrator", &NumericsConfig::integrator,
             {.doc = "time integration: midpoint rule, Heun's third order, classical fourth order; midpoint rule of "
                     "three stages whose slopes are made once a step",
              .choices = {"rk2", "rk3", "rk4", "hybrid3"}})
        .key("trap_gap", &NumericsConfig::trap_gap,
             {.unit = "dx",
              .doc = "particles between two walls that have come nearer to each other are taken out and counted as "
                     "trapped; 0: none is",
              .min = 0,
              .max = 1});
}

base::Table<ParallelConfig> parallel_table()
{
    return base::Table<ParallelConfig>("the cut of the fluid into ranks; results do not depend on it")
        .key("imbalance_limit", &ParallelConfig::imbalance_limit,
             {.unit = "-",
              .doc = "largest measured time of a rank over the mean before the fluid is cut anew",
              .min = 1.0})
        .key("rebuilds_between", &ParallelConfig::rebuilds_between,
             {.unit = "-", .doc = "neighbour list rebuilds between two attempts to cut it, at least", .min = 1});
}

} // namespace sph

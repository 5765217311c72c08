// SPDX-License-Identifier: MIT
#include "fem_solver/config/analysis_config.hpp"

namespace fem {

base::Table<AnalysisConfig> analysis_table()
{
    return base::Table<AnalysisConfig>("what is solved")
        .key("kind", &AnalysisConfig::kind,
             {.doc = "dynamic: motion over time; static: equilibrium, modal: natural frequencies, both alone only",
              .choices = {"dynamic", "static", "modal"}})
        .key("load_steps", &AnalysisConfig::load_steps,
             {.unit = "-",
              .doc = "static and initial equilibrium: parts in which the loads are raised; one that does "
                     "not converge is cut in halves",
              .min = 1,
              .max = 100000})
        .key("initial_equilibrium", &AnalysisConfig::initial_equilibrium,
             {.doc = "modal: vibrations about the equilibrium under gravity and loads, not about the unloaded state; "
                     "dynamic: the motion starts at rest from the equilibrium under gravity and the loads of this file "
                     "at t = 0; a fluid's load acts from its first packet on. false: from the undeformed state"})
        .key("modes", &AnalysisConfig::modes,
             {.unit = "-", .doc = "modal: how many, from the lowest", .min = 1, .max = 10000});
}

base::Table<TimeConfig> time_table()
{
    return base::Table<TimeConfig>("integration over time")
        .key("scheme", &TimeConfig::scheme, {.doc = "HHT in its full form", .choices = {"hht"}})
        .key("alpha", &TimeConfig::alpha,
             {.unit = "-",
              .doc = "0: no numerical damping; negative: damps high frequencies",
              .min = -1.0 / 3,
              .max = 0})
        .key("dt", &TimeConfig::dt,
             {.unit = "s", .doc = "step length of a run alone; coupled, the fluid sets it", .min = 0})
        .key("end", &TimeConfig::end, {.unit = "s", .doc = "end of a run alone; coupling.toml overrules it", .min = 0})
        .key("sub_steps", &TimeConfig::sub_steps,
             {.unit = "-",
              .doc =
                  "HHT steps in each step; a fluid's load changes linearly over them. Beside that a step that does not "
                  "converge is cut in halves by itself",
              .min = 1,
              .max = 10000});
}

base::Table<InitialConfig> initial_table()
{
    return base::Table<InitialConfig>("the motion at the start")
        .key("velocity", &InitialConfig::velocity,
             {.unit = "m/s", .doc = "of all nodes, one number a dimension; supports keep theirs. Empty: at rest"});
}

base::Table<NewtonConfig> newton_table()
{
    return base::Table<NewtonConfig>("the nonlinear iteration of a step")
        .key("tolerance", &NewtonConfig::tolerance,
             {.unit = "-", .doc = "largest nodal residual over the largest nodal force", .max = 1e-2, .positive = true})
        .key("max_iterations", &NewtonConfig::max_iterations,
             {.unit = "-", .doc = "in one step", .min = 1, .max = 1000})
        .key("contraction", &NewtonConfig::contraction,
             {.unit = "-",
              .doc = "dynamic: a kept factorisation is renewed when the residual falls by less",
              .max = 1,
              .positive = true})
        .key("predictor", &NewtonConfig::predictor,
             {.doc = "dynamic: first iterate of a step: displacements change as over the step before, or as the "
                     "acceleration at its start has it, or not at all",
              .choices = {"continued", "constant_acceleration", "still"}});
}

base::Table<LinearSolverConfig> linear_solver_table()
{
    return base::Table<LinearSolverConfig>("the systems of linear equations")
        .key("method", &LinearSolverConfig::method,
             {.doc =
                  "automatic: banded on one rank where the body is slender, else mumps; banded, sparse: direct, on "
                  "one rank; mumps: direct, on any number of ranks; gamg, hypre: GMRES with algebraic multigrid, for "
                  "large bodies in 3D",
              .choices = {"automatic", "banded", "sparse", "mumps", "gamg", "hypre"}})
        .key("tolerance", &LinearSolverConfig::tolerance,
             {.unit = "-", .doc = "gamg, hypre: residual over right-hand side", .max = 1e-3, .positive = true})
        .key("options", &LinearSolverConfig::options,
             {.doc = "of PETSc, for experts, with the prefix solver_: \"-solver_ksp_monitor -solver_pc_gamg_threshold "
                     "0.02\""});
}

base::Table<ProbeConfig> probe_table()
{
    return base::Table<ProbeConfig>("values at the node nearest to a position, one column a component")
        .key("name", &ProbeConfig::name, {.doc = "first part of the column's name", .required = true})
        .key("position", &ProbeConfig::position, {.unit = "m", .doc = "in the reference state", .required = true})
        .key("quantities", &ProbeConfig::quantities,
             {.doc = "what is written; load: the fluid's force on the node, as in the step that ended",
              .choices = {"displacement", "velocity", "acceleration", "load"}});
}

base::Table<OutputConfig> output_table()
{
    return base::Table<OutputConfig>("when a run alone writes; coupling.toml decides in a coupled run")
        .key("interval", &OutputConfig::interval,
             {.unit = "s", .doc = "between two field outputs; 0: start and end only", .min = 0})
        .key("table_interval", &OutputConfig::table_interval,
             {.unit = "s", .doc = "between two rows of the CSV tables; 0: every step", .min = 0});
}

} // namespace fem

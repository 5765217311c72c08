// SPDX-License-Identifier: MIT
#include "coupler_lib/fake/fake_config.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace coupler {
namespace {

base::Table<PistonSurfaceConfig> surface_table()
{
    return base::Table<PistonSurfaceConfig>("the flat, rigid wet surface")
        .key("start", &PistonSurfaceConfig::start,
             {.unit = "m",
              .doc = "one end, spring relaxed; the body lies on the left of start -> end",
              .required = true})
        .key("end", &PistonSurfaceConfig::end, {.unit = "m", .doc = "other end", .required = true})
        .key("facets", &PistonSurfaceConfig::facets, {.unit = "-", .doc = "number of facets", .min = 1, .max = 1e6})
        .key("axis", &PistonSurfaceConfig::axis,
             {.unit = "-", .doc = "direction of positive displacement", .required = true});
}

base::Table<OscillatorConfig> piston_table()
{
    return base::Table<OscillatorConfig>("mass and spring, per wet area: m a + k u = f + m g along the axis")
        .key("mass", &OscillatorConfig::mass,
             {.unit = "kg/m^2", .doc = "mass per area", .positive = true, .required = true})
        .key("stiffness", &OscillatorConfig::stiffness,
             {.unit = "N/m^3", .doc = "spring per area", .min = 0, .required = true})
        .key("displacement", &OscillatorConfig::displacement,
             {.unit = "m", .doc = "at the start, from the relaxed spring"})
        .key("velocity", &OscillatorConfig::velocity, {.unit = "m/s", .doc = "at the start"})
        .key("gravity", &OscillatorConfig::gravity, {.unit = "m/s^2", .doc = "along the axis, negative: against it"})
        .key("integrator", &OscillatorConfig::integrator,
             {.doc = "hht: as fem_solver; exact: the exact motion under a load constant in the step",
              .choices = {"hht", "exact"}})
        .key("alpha", &OscillatorConfig::alpha,
             {.unit = "-", .doc = "HHT parameter; 0: trapezoidal rule", .min = -1.0 / 3.0, .max = 0});
}

base::Table<FakeRunConfig> run_table()
{
    return base::Table<FakeRunConfig>("pretended cost")
        .key("sleep", &FakeRunConfig::sleep,
             {.unit = "s", .doc = "computing time that a step pretends to take", .min = 0});
}

base::Table<FaultConfig> fault_table()
{
    return base::Table<FaultConfig>("a failure to be acted out, to test how a run ends")
        .key("kind", &FaultConfig::kind,
             {.doc = "throw: an error; nan: a value that is not a number (fluid: at a step, solid: at an exchange); "
                     "kill, crash, terminate, stop: SIGKILL, SIGSEGV, "
                     "SIGTERM, SIGSTOP to itself; silent: no answer; leave: ends early",
              .choices = {"none", "throw", "nan", "kill", "crash", "terminate", "stop", "silent", "leave"}})
        .key("moment", &FaultConfig::moment,
             {.doc =
                  "start: before the first exchange; exchange: in the middle of one; step: while computing; end: when "
                  "all steps are done",
              .choices = {"start", "exchange", "step", "end"}})
        .key("step", &FaultConfig::step, {.unit = "-", .doc = "at which step", .min = 0})
        .key("rank", &FaultConfig::rank, {.unit = "-", .doc = "on which of the program's ranks", .min = 0});
}

base::Table<FakeFluidStepConfig> fluid_table()
{
    return base::Table<FakeFluidStepConfig>("the fake fluid's step")
        .key("dt", &FakeFluidStepConfig::dt, {.unit = "s", .doc = "time step", .positive = true, .required = true})
        .key("impedance", &FakeFluidStepConfig::impedance,
             {.unit = "kg/(m^2 s)", .doc = "rho c, as told to the solid", .min = 0})
        .key("radiating", &FakeFluidStepConfig::radiating,
             {.doc = "adds the pressure rho c v.n of an unbounded fluid, n out of the solid: its exact answer is a "
                     "damper"});
}

base::Table<PressureConfig> pressure_table()
{
    return base::Table<PressureConfig>("prescribed pressure on every facet")
        .key("kind", &PressureConfig::kind,
             {.doc = "in time, or hydrostatic over the height y",
              .choices = {"constant", "ramp", "sine", "hydrostatic"}})
        .key("value", &PressureConfig::value, {.unit = "Pa", .doc = "constant, end of the ramp, amplitude of the sine"})
        .key("duration", &PressureConfig::duration, {.unit = "s", .doc = "of the ramp", .positive = true})
        .key("frequency", &PressureConfig::frequency, {.unit = "Hz", .doc = "of the sine", .min = 0})
        .key("level", &PressureConfig::level, {.unit = "m", .doc = "hydrostatic: height y of the surface"})
        .key("density", &PressureConfig::density, {.unit = "kg/m^3", .doc = "hydrostatic", .positive = true})
        .key("gravity", &PressureConfig::gravity, {.unit = "m/s^2", .doc = "hydrostatic, downwards", .min = 0});
}

void check_vector(const base::ConfigReader& reader, const std::string& key, const std::vector<double>& value)
{
    base::require_input(value.size() == 2, reader.where("surface." + key), ": [surface] ", key, " has ", value.size(),
                        " components; 2 are wanted");
}

} // namespace

FakeSolidConfig read_fake_solid(base::ConfigReader& reader)
{
    FakeSolidConfig config;
    config.surface = reader.table("surface", surface_table());
    config.piston = reader.table("piston", piston_table());
    config.run = reader.table("run", run_table());
    config.fault = reader.table("fault", fault_table());
    reader.finish();
    if (reader.describing()) return config;
    check_vector(reader, "start", config.surface.start);
    check_vector(reader, "end", config.surface.end);
    check_vector(reader, "axis", config.surface.axis);
    return config;
}

FakeFluidConfig read_fake_fluid(base::ConfigReader& reader)
{
    FakeFluidConfig config;
    config.fluid = reader.table("fluid", fluid_table());
    config.pressure = reader.table("pressure", pressure_table());
    config.run = reader.table("run", run_table());
    config.fault = reader.table("fault", fault_table());
    reader.finish();
    return config;
}

} // namespace coupler

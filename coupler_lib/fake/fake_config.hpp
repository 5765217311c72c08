// SPDX-License-Identifier: MIT
#pragma once
#include "coupler_lib/base/config.hpp"
#include "coupler_lib/fake/fault.hpp"
#include "coupler_lib/fake/oscillator.hpp"
#include "coupler_lib/fake/pressure_law.hpp"

#include <vector>

namespace coupler {

/// [run] of both fakes.
struct FakeRunConfig {
    double sleep = 0; ///< pretended computing time of a step [s]
};

/// [surface]: the flat rigid wet surface of the piston.
struct PistonSurfaceConfig {
    std::vector<double> start, end; ///< its ends with the spring relaxed; the body lies on the left of start -> end [m]
    int facets = 10;
    std::vector<double> axis; ///< direction of motion; its length does not matter
};

/// solid.toml of fake_solid.
struct FakeSolidConfig {
    PistonSurfaceConfig surface;
    OscillatorConfig piston;
    FakeRunConfig run;
    FaultConfig fault;
};

/// [fluid] of fake_fluid.
struct FakeFluidStepConfig {
    double dt = 0;          ///< [s]
    double impedance = 0;   ///< rho c that it reports [kg/(m^2 s)]
    bool radiating = false; ///< adds the reaction rho c v.n of an unbounded fluid to the pressure
};

/// fluid.toml of fake_fluid.
struct FakeFluidConfig {
    FakeFluidStepConfig fluid;
    PressureConfig pressure;
    FakeRunConfig run;
    FaultConfig fault;
};

/// Throw base::Error(bad_input) with the place of what is wrong.
FakeSolidConfig read_fake_solid(base::ConfigReader& reader);
FakeFluidConfig read_fake_fluid(base::ConfigReader& reader);

} // namespace coupler

// SPDX-License-Identifier: MIT
#include "sph_solver/config/water_config.hpp"

namespace sph {

base::Table<WaterConfig> water_table()
{
    return base::Table<WaterConfig>("a body of water at the start")
        .key("shape", &WaterConfig::shape,
             {.doc = "box: low to high; disc: rings about a centre", .choices = {"box", "disc"}})
        .key("low", &WaterConfig::low, {.unit = "m", .doc = "lowest corner of a box"})
        .key("high", &WaterConfig::high, {.unit = "m", .doc = "highest corner of a box"})
        .key("centre", &WaterConfig::centre, {.unit = "m", .doc = "centre of a disc"})
        .key("radius", &WaterConfig::radius, {.unit = "m", .doc = "radius of a disc", .min = 0})
        .key("velocity", &WaterConfig::velocity, {.unit = "m/s", .doc = "velocity at the start; none: at rest"});
}

base::Table<InitialConfig> initial_table()
{
    return base::Table<InitialConfig>("pressure at the start")
        .key("state", &InitialConfig::state,
             {.doc = "hydrostatic: from the free surface down; uniform: one pressure",
              .choices = {"hydrostatic", "uniform"}})
        .key(
            "level", &InitialConfig::level,
            {.unit = "m",
             .doc =
                 "height of the free surface, measured against gravity from the origin; inf: top of the highest water"})
        .key("pressure", &InitialConfig::pressure, {.unit = "Pa", .doc = "pressure of the uniform state"});
}

base::Table<OutflowConfig> outflow_table()
{
    return base::Table<OutflowConfig>("an opening: particles beyond the plane are taken out and counted")
        .key("name", &OutflowConfig::name, {.doc = "name in messages"})
        .key("point", &OutflowConfig::point, {.unit = "m", .doc = "a point of the plane", .required = true})
        .key("normal", &OutflowConfig::normal,
             {.unit = "-", .doc = "direction out of the domain; its length does not matter", .required = true});
}

} // namespace sph

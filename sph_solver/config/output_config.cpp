// SPDX-License-Identifier: MIT
#include "sph_solver/config/output_config.hpp"

namespace sph {

base::Table<OutputConfig> output_table()
{
    return base::Table<OutputConfig>("what is written; a coupled run takes its intervals from coupling.toml")
        .key("interval", &OutputConfig::interval,
             {.unit = "s", .doc = "between two writings of all particles; 0: at the start and the end only", .min = 0})
        .key("table_interval", &OutputConfig::table_interval,
             {.unit = "s", .doc = "between two rows of energy.csv and probes.csv; 0: a row every step", .min = 0});
}

base::Table<ProbeConfig> probe_table()
{
    return base::Table<ProbeConfig>("a quantity followed over time in probes.csv")
        .key("name", &ProbeConfig::name, {.doc = "first part of the column's name", .required = true})
        .key("quantity", &ProbeConfig::quantity,
             {.doc =
                  "pressure and velocity: kernel average at a point; wall_pressure: mean over the particles before a "
                  "square sensor in a wall; front and back: largest and smallest coordinate of the water along the "
                  "axis; "
                  "mass, kinetic: of the water in the box; semi_axes: of the ellipse with the water's second moments",
              .choices = {"pressure", "velocity", "wall_pressure", "front", "back", "mass", "kinetic", "semi_axes"}})
        .key("point", &ProbeConfig::point, {.unit = "m", .doc = "where, for pressure, velocity and wall_pressure"})
        .key("low", &ProbeConfig::low, {.unit = "m", .doc = "lowest corner of the box looked at; none: everywhere"})
        .key("high", &ProbeConfig::high, {.unit = "m", .doc = "highest corner of that box"})
        .key("axis", &ProbeConfig::axis,
             {.doc = "direction of front and back; normal of the sensor's wall", .choices = {"x", "y", "z"}})
        .key("size", &ProbeConfig::size, {.unit = "m", .doc = "side of the sensor of wall_pressure", .min = 0});
}

} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/config/water_config.hpp"

namespace sph {

base::Table<WaterConfig> water_table()
{
    return base::Table<WaterConfig>("a body of water at the start; bodies may touch, not overlap")
        .key("shape", &WaterConfig::shape,
             {.doc = "box: low to high; disc: rings about a centre (2D); polygon: through points (2D); stl: inside a "
                     "closed surface (3D); film: what of the box low to high is above the heights of a ground file; "
                     "particles: as a file lists them",
              .choices = {"box", "disc", "polygon", "stl", "film", "particles"}})
        .key("low", &WaterConfig::low, {.unit = "m", .doc = "lowest corner of a box or film"})
        .key("high", &WaterConfig::high, {.unit = "m", .doc = "highest corner of a box or film"})
        .key("centre", &WaterConfig::centre, {.unit = "m", .doc = "centre of a disc"})
        .key("radius", &WaterConfig::radius, {.unit = "m", .doc = "radius of a disc", .min = 0})
        .key("points", &WaterConfig::points,
             {.unit = "m", .doc = "corners [[x, y], ...] of a polygon, either way round"})
        .key("file", &WaterConfig::file,
             {.doc = "STL file, file of a ground as for [[walls]], or HDF5 file of particles; its path is seen from "
                     "the folder of this file"})
        .key("scale", &WaterConfig::scale,
             {.unit = "m", .doc = "what one unit of the STL file is worth: 0.001 for millimetres", .positive = true})
        .key("group", &WaterConfig::group,
             {.doc = "group of the HDF5 file that holds points, volume and, if known, velocity and density"})
        .key("velocity", &WaterConfig::velocity,
             {.unit = "m/s",
              .doc =
                  "velocity at the start, a number or a formula of x, y (, z) for each component; none: at rest, or as "
                  "the file of particles says"})
        .key("level", &WaterConfig::level,
             {.unit = "m", .doc = "free surface of this body, where it differs from [initial] level"});
}

base::Table<InitialConfig> initial_table()
{
    return base::Table<InitialConfig>("pressure at the start; the density follows from it")
        .key("state", &InitialConfig::state,
             {.doc = "hydrostatic: from the free surface down; uniform: one pressure; field: pressure as a formula",
              .choices = {"hydrostatic", "uniform", "field"}})
        .key(
            "level", &InitialConfig::level,
            {.unit = "m",
             .doc =
                 "height of the free surface, measured against gravity from the origin; inf: top of the highest water"})
        .key("pressure", &InitialConfig::pressure,
             {.unit = "Pa", .doc = "uniform: a number; field: a formula of x, y (, z), e.g. \"500*(1 - x^2 - y^2)\""});
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

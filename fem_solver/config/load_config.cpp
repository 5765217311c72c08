// SPDX-License-Identifier: MIT
#include "fem_solver/config/load_config.hpp"

namespace fem {

base::Table<SupportConfig> support_table()
{
    return base::Table<SupportConfig>("displacements held at zero on a group of nodes")
        .key("group", &SupportConfig::group, {.doc = "of the mesh", .required = true})
        .key("fix", &SupportConfig::fix, {.doc = "held components", .required = true, .choices = {"x", "y", "z"}});
}

base::Table<LoadConfig> load_table()
{
    return base::Table<LoadConfig>("a load on a group of faces, or on a node")
        .key("kind", &LoadConfig::kind,
             {.doc = "pressure: normal to the faces, positive in compression; traction: force per area in a fixed "
                     "direction; "
                     "nodal_force: on the node nearest to a position",
              .required = true,
              .choices = {"pressure", "traction", "nodal_force"}})
        .key("group", &LoadConfig::group, {.doc = "of faces; for pressure and traction"})
        .key("pressure", &LoadConfig::pressure, {.unit = "Pa", .doc = "uniform pressure"})
        .key("distribution", &LoadConfig::distribution,
             {.doc = "of a pressure. hydrostatic: density gravity (level - Y) below the level, Y the reference height "
                     "(y in "
                     "2D, z in 3D), which does not change when the body moves",
              .choices = {"uniform", "hydrostatic"}})
        .key("density", &LoadConfig::density, {.unit = "kg/m^3", .doc = "of the liquid; hydrostatic", .min = 0})
        .key("level", &LoadConfig::level, {.unit = "m", .doc = "height of the free surface; hydrostatic"})
        .key("gravity", &LoadConfig::gravity, {.unit = "m/s^2", .doc = "of the liquid; hydrostatic", .min = 0})
        .key("follower", &LoadConfig::follower,
             {.doc = "the pressure turns with the face; false: it keeps its direction and area"})
        .key("traction", &LoadConfig::traction, {.unit = "Pa", .doc = "per reference area, one number a dimension"})
        .key("position", &LoadConfig::position, {.unit = "m", .doc = "of the node; nodal_force"})
        .key("force", &LoadConfig::force, {.unit = "N (2D: N/m)", .doc = "one number a dimension; nodal_force"});
}

base::Table<InterfaceConfig> interface_table()
{
    return base::Table<InterfaceConfig>("the wet surface, when the solid is coupled to a fluid")
        .key("groups", &InterfaceConfig::groups, {.doc = "groups of faces that the fluid may touch"})
        .key("smoothing_steps", &InterfaceConfig::smoothing_steps,
             {.unit = "-",
              .doc = "parallel_impedance: the wall's mean acceleration over about so many steps is no news to the "
                     "fluid and "
                     "is not answered; 0: every change of velocity is",
              .min = 0,
              .max = 10000});
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/config/load_config.hpp"

namespace fem {

base::Table<SupportConfig> support_table()
{
    return base::Table<SupportConfig>("displacements held on a group of nodes, at zero or on a path")
        .key("group", &SupportConfig::group, {.doc = "of the mesh", .required = true})
        .key("fix", &SupportConfig::fix, {.doc = "components held at zero", .choices = {"x", "y", "z"}})
        .key("symmetry", &SupportConfig::symmetry,
             {.doc = "the group is a plane of symmetry, made of faces, across x, y or z: its normal component is held"})
        .key("ux", &SupportConfig::ux,
             {.unit = "m",
              .doc = "displacement along x, a formula of the time t [s] and the reference position x, y, z [m]; "
                     "velocity and acceleration are its derivatives. Static: t is the load factor, 0 to 1"})
        .key("uy", &SupportConfig::uy, {.unit = "m", .doc = "along y"})
        .key("uz", &SupportConfig::uz, {.unit = "m", .doc = "along z"})
        .key("derivative_step", &SupportConfig::derivative_step,
             {.unit = "s",
              .doc = "h of the formulas' derivatives, central differences of sixth order; short against the motion",
              .positive = true});
}

base::Table<DriveConfig> drive_table()
{
    return base::Table<DriveConfig>(
               "a group of nodes moved as a rigid body: a shift of its centre and a turn about it; the moment of its "
               "reaction is in reactions.csv, its work in energy.csv")
        .key("group", &DriveConfig::group, {.doc = "of the mesh", .required = true})
        .key("centre", &DriveConfig::centre,
             {.unit = "m", .doc = "point of the turn in the reference state", .required = true})
        .key("axis", &DriveConfig::axis, {.unit = "-", .doc = "of the turn, 3D; 2D turns about z"})
        .key("x", &DriveConfig::x,
             {.unit = "m",
              .doc = "shift of the centre, a formula of the time t [s]; velocity and acceleration are its derivatives. "
                     "Static: t is the load factor, 0 to 1"})
        .key("y", &DriveConfig::y, {.unit = "m", .doc = "along y"})
        .key("z", &DriveConfig::z, {.unit = "m", .doc = "along z, 3D"})
        .key("angle", &DriveConfig::angle, {.unit = "rad", .doc = "of the turn, a formula of the time t [s]"})
        .key("derivative_step", &DriveConfig::derivative_step,
             {.unit = "s",
              .doc = "h of the formulas' derivatives, central differences of sixth order; short against the motion",
              .positive = true});
}

base::Table<LoadConfig> load_table()
{
    return base::Table<LoadConfig>("a load on a group of faces or nodes, or on a node")
        .key("name", &LoadConfig::name, {.doc = "of its column of work in energy.csv; empty: load1, load2, ..."})
        .key("kind", &LoadConfig::kind,
             {.doc = "pressure: normal to the faces, positive in compression; traction: force per reference area in a "
                     "fixed direction; follower_traction: turned with the faces; nodal_force: on each node of a group "
                     "or on the node nearest to a position; spring: to the ground, force - stiffness u",
              .required = true,
              .choices = {"pressure", "traction", "follower_traction", "nodal_force", "spring"}})
        .key("group", &LoadConfig::group, {.doc = "of faces; of nodes for nodal_force"})
        .key("factor", &LoadConfig::factor,
             {.unit = "-",
              .doc = "of the load, a formula of the time t [s]; springs have none. Static: t is the load factor, by "
                     "which the load is multiplied as well"})
        .key("pressure", &LoadConfig::pressure,
             {.unit = "Pa",
              .doc = "pressure, a number or a formula of the reference position x, y, z [m]; distribution uniform"})
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
        .key("traction", &LoadConfig::traction,
             {.unit = "Pa", .doc = "per reference area, one number a dimension; traction, follower_traction"})
        .key("position", &LoadConfig::position, {.unit = "m", .doc = "of the node; nodal_force and spring"})
        .key("force", &LoadConfig::force, {.unit = "N (2D: N/m)", .doc = "one number a dimension; nodal_force"})
        .key("stiffness", &LoadConfig::stiffness,
             {.unit = "N/m^3",
              .doc = "spring: one number a dimension, per reference area of a group; at a position N/m (2D: N/m^2)",
              .min = 0});
}

base::Table<InterfaceConfig> interface_table()
{
    return base::Table<InterfaceConfig>("the wet surface, when the solid is coupled to a fluid")
        .key("groups", &InterfaceConfig::groups, {.doc = "groups of faces that the fluid may touch"});
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/config/contact_config.hpp"

namespace fem {

base::Table<ContactConfig> contact_table()
{
    return base::Table<ContactConfig>("contact of a group of faces with a rigid ground, with Coulomb friction")
        .key("group", &ContactConfig::group, {.doc = "of faces", .required = true})
        .key("ground", &ContactConfig::ground,
             {.doc = "plane: through a point; formula: height over x (3D: x, y); table: the same from a file. The "
                     "solid side "
                     "of a height is below it. surface: triangles from an STL file (2D: a line of points from a CSV "
                     "file), which end where they end",
              .choices = {"plane", "formula", "table", "surface"}})
        .key("point", &ContactConfig::point, {.unit = "m", .doc = "plane: on it; empty: the origin"})
        .key("normal", &ContactConfig::normal,
             {.unit = "-", .doc = "plane: out of the ground, of any length; empty: upwards (2D: y, 3D: z)"})
        .key("height", &ContactConfig::height, {.unit = "m", .doc = "formula: of x (and y in 3D) [m]"})
        .key("derivative_step", &ContactConfig::derivative_step,
             {.unit = "m", .doc = "formula: of its differences; short against its waves", .positive = true})
        .key("file", &ContactConfig::file,
             {.doc = "table: CSV with x[m], (y[m],) height[m] on a regular lattice, HDF5 with the datasets x, (y,) "
                     "height, or TOML with height = \"FORMULA\", which the fluid's wall reads too; surface: STL whose "
                     "normals point out of the ground, in 2D CSV with x[m], y[m] along a "
                     "line that has the ground on its right; a path from the folder of this file"})
        .key("scale", &ContactConfig::scale,
             {.unit = "m", .doc = "surface: one unit of the STL file, which has none of its own", .positive = true})
        .key("ux", &ContactConfig::ux,
             {.unit = "m",
              .doc = "displacement of the ground along x, a formula of the time t [s] (static: of the load factor)"})
        .key("uy", &ContactConfig::uy, {.unit = "m", .doc = "along y"})
        .key("uz", &ContactConfig::uz, {.unit = "m", .doc = "along z"})
        .key("friction", &ContactConfig::friction, {.unit = "-", .doc = "Coulomb's coefficient", .min = 0, .max = 10})
        .key("formulation", &ContactConfig::formulation,
             {.doc = "augmented_lagrangian: the gap is closed to the tolerance; penalty: it stays in proportion to the "
                     "pressure; automatic: the first in statics, the second in motion, where closed gaps chatter",
              .choices = {"automatic", "augmented_lagrangian", "penalty"}})
        .key("penalty_factor", &ContactConfig::penalty_factor,
             {.unit = "-", .doc = "penalty over the stiffness of the body's surface per area", .positive = true})
        .key("stick_factor", &ContactConfig::stick_factor,
             {.unit = "-",
              .doc = "penalty against sliding before friction gives way, over the one against the gap",
              .positive = true})
        .key("tolerance", &ContactConfig::tolerance,
             {.unit = "-",
              .doc = "gap that may be left in contact, over the size of a face",
              .max = 1,
              .positive = true})
        .key("max_augmentations", &ContactConfig::max_augmentations,
             {.unit = "-", .doc = "in one step", .min = 1, .max = 10000});
}

} // namespace fem

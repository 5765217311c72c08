// SPDX-License-Identifier: MIT
#include "fem_solver/config/body_config.hpp"

namespace fem {

base::Table<ModelConfig> model_table()
{
    return base::Table<ModelConfig>("what kind of solid is computed")
        .key("dimension", &ModelConfig::dimension, {.unit = "-", .doc = "of space", .min = 2, .max = 3})
        .key("assumption", &ModelConfig::assumption,
             {.doc = "in 2D; plane_strain: no stretch across the plane; plane_stress: no stress there. Ignored in 3D",
              .choices = {"plane_strain", "plane_stress"}});
}

base::Table<MeshConfig> mesh_table()
{
    return base::Table<MeshConfig>(
               "the mesh; a block has the groups left, right, bottom, top (3D: back, front) and all")
        .key("kind", &MeshConfig::kind,
             {.doc = "block: rectangle or box cut into equal cells; med: a file of Gmsh, Salome or Code_Aster",
              .choices = {"block", "med"}})
        .key("file", &MeshConfig::file, {.doc = "med: the file; a path from the folder of this file"})
        .key("name", &MeshConfig::name, {.doc = "med: of the mesh in the file; empty: the only one"})
        .key("scale", &MeshConfig::scale, {.unit = "m", .doc = "med: length of the file's unit", .positive = true})
        .key("low", &MeshConfig::low, {.unit = "m", .doc = "block: lower corner"})
        .key("high", &MeshConfig::high, {.unit = "m", .doc = "block: upper corner"})
        .key("cells", &MeshConfig::cells,
             {.unit = "-", .doc = "block: number of elements along each direction", .min = 1})
        .key("element", &MeshConfig::element,
             {.doc = "block: shape of the elements: 2D tri or quad, 3D tet or hexa, with their number of nodes; a "
                     "block cuts "
                     "each cell "
                     "into 2 triangles or 6 tetrahedra",
              .choices = {"tri3", "tri6", "quad4", "quad8", "quad9", "tet4", "tet10", "hexa8", "hexa20", "hexa27"}})
        .key("integration", &MeshConfig::integration,
             {.doc = "of quad8 and hexa20: reduced has 2, full 3 points a direction; full is stiffer, there to compare",
              .choices = {"reduced", "full"}})
        .key(
            "formulation", &MeshConfig::formulation,
            {.doc =
                 "enhanced: quad4 and hexa8 with modes against locking; mixed: with a pressure in each element, linear "
                 "in quad9 and hexa27, constant in quad4, hexa8, tri6 and tet10, for nu near 0.5; standard: "
                 "displacements alone, which lets quad4 and hexa8 lock; automatic: enhanced for quad4 and hexa8, mixed "
                 "for quad9 and hexa27",
             .choices = {"automatic", "enhanced", "mixed", "standard"}});
}

base::Table<MaterialConfig> material_table()
{
    return base::Table<MaterialConfig>("the solid's material")
        .key("law", &MaterialConfig::law,
             {.doc = "elastic: Hooke (small kinematics) or St. Venant-Kirchhoff (finite), neo_hookean, both from E; "
                     "mooney_rivlin: from c10, c01; ogden: from mu, alpha; marlow: from a measured curve. All but "
                     "elastic: energy psi(shape) + K/2 (J - 1)^2, K from the shear modulus and nu (see volumetric)",
              .choices = {"elastic", "neo_hookean", "mooney_rivlin", "ogden", "marlow"}})
        .key("E", &MaterialConfig::young, {.unit = "Pa", .doc = "Young's modulus; elastic, neo_hookean", .min = 0})
        .key("nu", &MaterialConfig::poisson,
             {.unit = "-", .doc = "Poisson's ratio", .min = -0.99, .max = 0.49999, .required = true})
        .key("density", &MaterialConfig::density,
             {.unit = "kg/m^3", .doc = "in the reference state", .positive = true, .required = true})
        .key("kinematics", &MaterialConfig::kinematics,
             {.doc = "finite: displacements and rotations of any size; small: linear, law elastic only",
              .choices = {"finite", "small"}})
        .key(
            "volumetric", &MaterialConfig::volumetric,
            {.doc =
                 "neo_hookean: quadratic: w = mu/2 (J^(-2/3) I1 - 3) + K/2 (J - 1)^2; logarithmic: w = mu/2 (I1 - 3) - "
                 "mu ln J + lambda/2 ln^2 J, not with the formulation mixed",
             .choices = {"quadratic", "logarithmic"}})
        .key("c10", &MaterialConfig::c10, {.unit = "Pa", .doc = "mooney_rivlin: psi = c10 (I1 - 3) + c01 (I2 - 3)"})
        .key("c01", &MaterialConfig::c01, {.unit = "Pa", .doc = "mooney_rivlin; the shear modulus is 2 (c10 + c01)"})
        .key("mu", &MaterialConfig::moduli,
             {.unit = "Pa",
              .doc = "ogden: psi = sum 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3); they add up to the shear "
                     "modulus"})
        .key("alpha", &MaterialConfig::exponents, {.unit = "-", .doc = "ogden: exponents, as many as mu, none zero"})
        .key("curve", &MaterialConfig::curve,
             {.doc = "marlow: CSV of a tension test with the columns strain[-] and stress[Pa], both nominal; a path "
                     "from the folder of this file"})
        .key("softening_r", &MaterialConfig::softening_r,
             {.unit = "-",
              .doc = "damage on unloading (Ogden and Roxburgh): stress times 1 - erf((W - w)/(m + beta W))/r, w the "
                     "energy of shape and W the largest so far; 0: none, else 1 or more. Mixed formulation only",
              .min = 0})
        .key("softening_m", &MaterialConfig::softening_m, {.unit = "J/m^3", .doc = "m there, above zero", .min = 0})
        .key("softening_beta", &MaterialConfig::softening_beta, {.unit = "-", .doc = "beta there", .min = 0})
        .key("stability_range", &MaterialConfig::stability_range,
             {.unit = "-",
              .doc = "principal stretches within which the law's Drucker stability is looked at",
              .min = 0.01,
              .max = 100});
}

base::Table<GravityConfig> gravity_table()
{
    return base::Table<GravityConfig>("the body's own weight")
        .key("acceleration", &GravityConfig::acceleration,
             {.unit = "m/s^2", .doc = "one number a dimension; empty: no gravity"});
}

base::Table<DampingConfig> damping_table()
{
    return base::Table<DampingConfig>("viscous damping C = stiffness K + mass M, K of the undeformed body")
        .key("stiffness", &DampingConfig::stiffness, {.unit = "s", .doc = "damps high frequencies", .min = 0})
        .key("mass", &DampingConfig::mass,
             {.unit = "1/s", .doc = "damps low frequencies, drags on rigid motion", .min = 0});
}

} // namespace fem

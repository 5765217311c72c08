// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/assembly/element_body.hpp"
#include "fem_solver/assembly/mixed_body.hpp"

namespace fem {

/// What `automatic` stands for.
template<class Shape> Formulation chosen(Formulation asked, bool splits)
{
    if (asked != Formulation::automatic) return asked;
    if (ElementBody<Shape>::can_enhance) return Formulation::enhanced;
    const bool linear_pressure = Shape::pressure_modes == Shape::dimension + 1;
    return linear_pressure && splits ? Formulation::mixed : Formulation::standard;
}

/// The body of a shape. Each shape has its own source file.
template<class Shape>
std::unique_ptr<SolidBody> make_element_body(const Mesh& mesh, const MatrixPattern& pattern, const Material& material,
                                             const BodySettings& settings)
{
    const bool sheet = Shape::dimension == 2 && material.sheet == Sheet::plane_stress; // free to change its volume
    const auto law = sheet ? std::nullopt : split(material.law);
    BodySettings own = settings;
    own.formulation = chosen<Shape>(settings.formulation, law.has_value());
    base::require_input(!material.softening.active() || own.formulation == Formulation::mixed,
                        "a material that softens (softening_r) needs [mesh] formulation = \"mixed\"");
    if (own.formulation != Formulation::mixed)
        return std::make_unique<ElementBody<Shape>>(mesh, pattern, material, own);
    base::require_input(Shape::pressure_modes > 0, "the element ", name_of(mesh.type),
                        " has no mixed formulation; quad4, quad9, tri6, hexa8, hexa27 and tet10 have one");
    base::require_input(law.has_value(), "the mixed formulation needs plane strain or 3D, and a law that separates "
                                         "shape and volume: neo_hookean, mooney_rivlin, ogden or marlow");
    if constexpr (Shape::pressure_modes > 0)
        return std::make_unique<MixedBody<Shape, Shape::pressure_modes>>(mesh, pattern, *law, material);
    return nullptr;
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/setup/formulation.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace fem {
namespace {

/// Poisson's ratio from which on the mixed formulation pays: the gate's tip (6 x 80 Quad9) is 0.4 % stiffer without.
constexpr double nearly_incompressible = 0.49;

} // namespace

BodySettings body_settings(const MeshConfig& config)
{
    const std::string& name = config.formulation;
    BodySettings settings{config.integration == "full", Formulation::automatic};
    if (name == "enhanced") settings.formulation = Formulation::enhanced;
    if (name == "mixed") settings.formulation = Formulation::mixed;
    if (name == "standard") settings.formulation = Formulation::standard;
    return settings;
}

std::string locking_warning(ElementType type, const SolidConfig& config)
{
    const BodySettings settings = body_settings(config.mesh);
    const std::string name = name_of(type);
    const bool standard = settings.formulation == Formulation::standard;
    const bool cured = type == ElementType::quad4 || type == ElementType::hexa8;
    const bool reducible = type == ElementType::quad8 || type == ElementType::hexa20;
    if (type == ElementType::tri3 || type == ElementType::tet4)
        return name + " is far too stiff in bending and locks near nu = 0.5: take six or ten nodes";
    if (cured && standard)
        return name + " with formulation = \"standard\" locks; it is there to show that. Take \"automatic\"";
    if (reducible && settings.full_integration)
        return name +
               " with integration = \"full\" is stiffer than with \"reduced\", at more cost; it is there to compare";
    const bool safe_by_itself = cured || type == ElementType::quad9 || type == ElementType::hexa27;
    const bool plain = standard || (!safe_by_itself && settings.formulation != Formulation::mixed);
    if (plain && config.material.poisson >= nearly_incompressible)
        return base::text(name, " by displacements alone is too stiff at nu = ", config.material.poisson,
                          ": take quad9 or hexa27 with formulation = \"mixed\"");
    return {};
}

} // namespace fem

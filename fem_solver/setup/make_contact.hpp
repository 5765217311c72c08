// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/assembly/solid_forces.hpp"
#include "fem_solver/config/contact_config.hpp"
#include "fem_solver/contact/ground_contact.hpp"

namespace fem {

/// The contact of a configuration; its penalty follows from the body's stiffness. \param dynamic for a motion, not for
/// statics alone. \throws base::Error bad_input.
std::unique_ptr<GroundContact> make_contact(const ContactConfig& config, const Mesh& mesh, const SolidForces& forces,
                                            bool dynamic);

} // namespace fem

// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/point_law.hpp"

namespace fem {

/// A law in a thin sheet whose faces are free: the stretch across the sheet follows from the stress there.
///
///     P_33(F, F_33) = 0,     dP/dF = A - A_(.33) A_(33.) / A_3333
///
/// Energies and stresses are per reference volume, so forces are per metre of undeformed thickness.
std::unique_ptr<PointLaw<2>> make_plane_stress(std::unique_ptr<PointLaw<3>> law);

} // namespace fem

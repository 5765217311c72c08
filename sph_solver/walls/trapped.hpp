// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/walls/mirror_plane.hpp"

#include <cstdint>
#include <vector>

namespace sph {

/// Which particles stand in a gap that closes: between two planes that face each other, n_p.n_q < cos_opposite, with
///
///     d_p + d_q < gap      d the particle's distance from a plane, negative inside the wall [m]
///
/// A film that thin is below the resolution: its particles would be pressed through the walls. Empty for gap = 0.
/// \return a mark for each owned particle, in the order of WallContact::row; \param owned their number.
template<int D> std::vector<std::uint8_t> find_trapped(const WallContacts<D>& contacts, double gap, std::size_t owned);

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/state/cell_grid.hpp"
#include "sph_solver/state/particles.hpp"

#include <vector>

namespace sph {

/// Sorts the local particles into the canonical order: by cell of the grid, then by global id. All columns and
/// `is_owned` move along; `owned` is made anew from `is_owned`. Returns the new index of each old one.
template<int D> std::vector<int> sort_canonically(Particles<D>& particles, const CellGrid<D>& grid);

/// Keeps the particles whose entry in `keep` is not 0, in their order. All must be owned (no halo copies).
template<int D> void keep_particles(Particles<D>& particles, const std::vector<std::uint8_t>& keep);

/// Drops all halo copies: what is left is owned, in canonical order, but its derived fields are out of date.
template<int D> void drop_halo(Particles<D>& particles);

} // namespace sph

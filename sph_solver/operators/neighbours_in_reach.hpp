// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/neighbour_list.hpp"
#include "sph_solver/operators/pair_records.hpp"

#include <vector>

namespace sph {

/// Leaves out of every row the neighbours that are beyond the kernel's support now: what the skin of the list holds
/// in reserve costs a comparison here instead of two passes of arithmetic that add zero. The order within a row stays.
///
/// \param reached the result; its storage is used again. \pre records.load_states was called for the present state.
template<int D>
void select_in_reach(NeighbourList& reached, const PairRecords<D>& records, const NeighbourList& neighbours,
                     const std::vector<int>& owned, double support);

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/operators/neighbours_in_reach.hpp"
#include "sph_solver/parallel/work_meter.hpp"
#include "sph_solver/walls/mirror_plane.hpp"

#include <vector>

namespace sph {

/// What one evaluation has to do on this rank, counted.
template<int D> WorkMeter::Counts count_work(const ReachedNeighbours& neighbours, const WallContacts<D>& contacts);

/// Cost of each owned particle in one evaluation [s]: its own, that of its neighbours and, at walls, of its images, with
/// the mean costs that the meter has found.
template<int D>
std::vector<double> work_costs(const WorkMeter& meter, const ReachedNeighbours& neighbours,
                               const WallContacts<D>& contacts);

} // namespace sph

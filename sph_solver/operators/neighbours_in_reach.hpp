// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/close_points.hpp"
#include "sph_solver/neighbours/neighbour_list.hpp"
#include "sph_solver/state/particles.hpp"

namespace sph {

/// Leaves out of every row the neighbours that are beyond the kernel's support now: what the skin of the list holds
/// in reserve costs a comparison here instead of two passes of arithmetic that add zero. The order within a row stays.
template<int D> class NeighboursInReach {
public:
    explicit NeighboursInReach(double support) : limit_(support * support) {}

    /// The list for the present positions; valid until the next call. `indices` may be longer than its rows: the storage
    /// of the last call is used again.
    const NeighbourList& select(const Particles<D>& particles, const NeighbourList& neighbours);

private:
    double limit_;
    PointRows<D> points_;
    NeighbourList reached_;
};

} // namespace sph

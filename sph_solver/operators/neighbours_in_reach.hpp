// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/close_points.hpp"
#include "sph_solver/neighbours/neighbour_list.hpp"
#include "sph_solver/neighbours/row_set.hpp"
#include "sph_solver/numerics/pack.hpp"
#include "sph_solver/state/particles.hpp"

#include <span>
#include <vector>

namespace sph {

/// Who sees whom now, in the form that the pair loops read: rows over the owned particles, ascending, each followed by
/// a unit or more of the particle itself, whose distance and jumps are exactly zero, and so is all that it adds.
struct ReachedNeighbours {
    std::vector<std::size_t> begins; ///< first entry of each row, a multiple of row_unit
    std::vector<std::size_t> splits; ///< first neighbour j > i of each row
    std::vector<std::size_t> ends;   ///< one past the last neighbour of each row
    std::vector<int> indices;        ///< local indices
    std::size_t longest = 0;         ///< entries of the longest row, whole units

    [[nodiscard]] std::size_t rows() const { return begins.size(); }

    /// Neighbours of the k-th owned particle.
    [[nodiscard]] std::span<const int> of(std::size_t k) const
    {
        return {indices.data() + begins[k], ends[k] - begins[k]};
    }

    /// The same row in whole packs: its last unit may lack the second of two, which would add zero.
    [[nodiscard]] std::span<const int> packs_of(std::size_t k) const
    {
        return {indices.data() + begins[k], (ends[k] - begins[k] + pack_lanes - 1) / pack_lanes * pack_lanes};
    }

    /// Its neighbours j < i, and those j > i.
    [[nodiscard]] std::span<const int> before(std::size_t k) const
    {
        return {indices.data() + begins[k], splits[k] - begins[k]};
    }
    [[nodiscard]] std::span<const int> after(std::size_t k) const
    {
        return {indices.data() + splits[k], ends[k] - splits[k]};
    }
};

/// Leaves out of every row the neighbours that are beyond the kernel's support now: what the skin of the list holds
/// in reserve costs a comparison here instead of two passes of arithmetic that add zero. The order within a row stays,
/// so that the sums do not depend on when the list was made.
template<int D> class NeighboursInReach {
public:
    explicit NeighboursInReach(double support) : limit_(support * support) {}

    /// All rows for the present positions; valid until the next call.
    const ReachedNeighbours& select(const Particles<D>& particles, const NeighbourList& neighbours);

    /// The same in parts: start, then take positions in and select rows whose neighbours have theirs taken in.
    void start(const Particles<D>& particles, const NeighbourList& neighbours);
    void take_positions(const Particles<D>& particles, const std::vector<int>& which);
    void select(const NeighbourList& neighbours, const RowSet& rows);

    /// What has been selected. `indices` may be longer than its rows: the storage of the last call is used again.
    const ReachedNeighbours& reached() const { return reached_; }

private:
    double limit_;
    PointRows<D> points_;
    ReachedNeighbours reached_;
    std::size_t next_ = 0; ///< where the next row is written
};

} // namespace sph

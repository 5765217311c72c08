// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/close_points.hpp"
#include "sph_solver/neighbours/neighbour_list.hpp"
#include "sph_solver/neighbours/row_set.hpp"
#include "sph_solver/numerics/pack.hpp"
#include "sph_solver/state/particles.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace sph {

/// The neighbours of one particle, ascending, followed by two units of the particle itself, whose distance and jumps are
/// exactly zero, and so is all that it adds.
struct ReachedRow {
    const int* begin = nullptr;
    std::size_t before = 0; ///< neighbours j < i
    std::size_t size = 0;

    [[nodiscard]] std::span<const int> all() const { return {begin, size}; }
    /// In whole packs: the last unit may lack the second of two, which would add zero.
    [[nodiscard]] std::span<const int> packs() const
    {
        return {begin, (size + pack_lanes - 1) / pack_lanes * pack_lanes};
    }
    [[nodiscard]] std::span<const int> ahead() const { return {begin, before}; }
    [[nodiscard]] std::span<const int> behind() const { return {begin + before, size - before}; }
};

/// What unfolding a row writes behind it.
inline constexpr std::size_t row_overhang = 2 * row_unit;

/// Who sees whom now: rows over the owned particles, kept as one bit for each entry of the list, and unfolded one at a time
/// in the form that the pair loops read.
class ReachedNeighbours {
public:
    /// \pre `list` outlives its use here. All entries are to be marked anew.
    void start(const NeighbourList& list);

    [[nodiscard]] std::size_t rows() const { return list_->rows(); }
    /// Entries of the longest row, whole units; may be larger.
    [[nodiscard]] std::size_t longest() const { return longest_; }
    /// How many neighbours row k has.
    [[nodiscard]] std::size_t count(std::size_t k) const;
    /// Row k, of particle i, written to `out`. \pre room for the longest row and row_overhang more
    ReachedRow unfold(std::size_t k, int i, int* out) const
    {
        const auto [end, before] = take<false>(k, i, out);
        std::fill_n(end, row_overhang, i);
        return {out, static_cast<std::size_t>(before), static_cast<std::size_t>(end - out)};
    }
    /// Its neighbours j > i alone. Returns their number.
    std::size_t unfold_behind(std::size_t k, int i, int* out) const
    {
        return static_cast<std::size_t>(take<true>(k, i, out).end - out);
    }
    /// The same as unfold, valid until the next row is asked for so.
    [[nodiscard]] ReachedRow row(std::size_t k, int i) const { return unfold(k, i, row_.data()); }
    /// Neighbours of the k-th owned particle, likewise.
    [[nodiscard]] std::span<const int> of(std::size_t k) const { return row(k, 0).all(); }

    /// The bits of row k, whole bytes.
    [[nodiscard]] std::uint8_t* bits_of(std::size_t k) { return &bits_[place(k)]; }

private:
    [[nodiscard]] std::size_t place(std::size_t k) const { return k + list_->words_before(k) / 8; }

    template<bool behind> [[gnu::always_inline]] inline Taken take(std::size_t k, int i, int* out) const
    {
        Taken taken{out};
        const std::uint8_t* bits = &bits_[place(k)];
        int first = 0;
        list_->for_each_block(k, [&](const NeighbourBlock& block) {
            take_marked<behind>(taken, block, bits, first, i);
            first += block.count;
        });
        return taken;
    }

    const NeighbourList* list_ = nullptr;
    std::vector<std::uint8_t> bits_;
    std::size_t longest_ = 0;
    mutable std::vector<int> row_; ///< the last that was asked for
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

    /// What has been selected.
    const ReachedNeighbours& reached() const { return reached_; }

private:
    double limit_;
    PointRows<D> points_;
    ReachedNeighbours reached_;
    std::vector<int> row_; ///< of the list, the one that is being compared
};

} // namespace sph

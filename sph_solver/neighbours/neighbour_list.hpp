// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/vector.hpp"
#include "sph_solver/state/particles.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace sph {

/// Which pairs something keeps apart, such as a plate thinner than the kernel. Both answers must depend on the positions
/// alone, else ranks would disagree.
template<int D> struct PairFilter {
    std::function<bool(const Vec<D>& x_i)> concerns; ///< may any pair of this particle be kept apart?
    std::function<bool(const Vec<D>& x_i, const Vec<D>& x_j)> lets_pass; ///< may they interact? symmetric
};

/// Some neighbours of a row: the local indices base + offsets[n]. Sixteen offsets more can be read.
struct NeighbourBlock {
    int base = 0;
    int count = 0;
    const std::uint16_t* offsets = nullptr;
};

/// Who may see whom, as compressed rows over the owned particles.
///
/// Row k belongs to the particle with local index particles.owned[k] and holds the local indices j != i with
/// |x_j - x_i| < reach at the time of the build, ascending: the canonical order of `Particles`. reach = 2 h + skin, so
/// that the list stays complete while no particle has moved further than skin / 2. Loops test r < 2 h themselves.
///
/// A row is stored in blocks (the base in two words, the count, the offsets), as few as indices of 16 bits allow: one, or
/// two or three in space with many particles. That takes half of the memory of plain indices.
class NeighbourList {
public:
    /// Drops all rows, and keeps the memory.
    void clear();
    /// Adds the next row, ascending.
    void append(std::span<const int> row);
    /// To be called after the last row: gives back memory that is not needed.
    void finish();

    [[nodiscard]] std::size_t rows() const { return begins_.size() - 1; }
    [[nodiscard]] std::size_t entries() const { return entries_; } ///< of all rows
    [[nodiscard]] std::size_t longest() const { return longest_; } ///< entries of the longest row
    /// Words of storage before row k, no fewer than the entries before it.
    [[nodiscard]] std::size_t words_before(std::size_t k) const { return begins_[k]; }

    /// Calls visit(block) for the blocks of row k, ascending.
    template<class Visit> [[gnu::always_inline]] inline void for_each_block(std::size_t k, Visit visit) const
    {
        const std::uint16_t* word = words_.data() + begins_[k];
        const std::uint16_t* const end = words_.data() + begins_[k + 1];
        while (word != end) {
            const NeighbourBlock block{static_cast<int>(word[0] | static_cast<unsigned>(word[1]) << 16), word[2],
                                       word + header};
            visit(block);
            word += header + block.count;
        }
    }

    /// Writes the indices of row k to `out` and returns their end. \pre room for `longest` and fifteen more
    [[gnu::always_inline]] inline int* copy(std::size_t k, int* out) const
    {
        for_each_block(k, [&](const NeighbourBlock& block) {
            for (int n = 0; n < block.count; n += 16)
                for (int lane = n; lane < n + 16; ++lane) out[lane] = block.base + block.offsets[lane];
            out += block.count;
        });
        return out;
    }

    /// Neighbours of the k-th owned particle.
    [[nodiscard]] std::vector<int> of(std::size_t k) const;

private:
    static constexpr int header = 3;

    std::vector<std::uint32_t> begins_ = {0}; ///< first word of each row, and the end
    std::vector<std::uint16_t> words_;
    std::size_t entries_ = 0, longest_ = 0;
};

} // namespace sph

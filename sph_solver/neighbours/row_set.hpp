// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/neighbour_list.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sph {

/// Rows of a neighbour list that an operator is to work on: all, or those of a list. Row k belongs to the particle with
/// local index owned[k]; results of rows do not depend on each other, so any split and order gives the same.
class RowSet {
public:
    RowSet(const std::vector<int>& owned) : owned_(owned), count_(owned.size()) {}
    RowSet(const std::vector<int>& owned, const std::vector<int>& some)
        : owned_(owned), some_(some.data()), count_(some.size())
    {}

    [[nodiscard]] std::size_t size() const { return count_; }
    /// Rows of the whole list.
    [[nodiscard]] std::size_t all() const { return owned_.size(); }

    /// Calls visit(k, i) for each row k and its particle i.
    template<class Visit> [[gnu::always_inline]] inline void for_each(Visit visit) const
    {
        for (std::size_t n = 0; n < count_; ++n) {
            const std::size_t k = some_ == nullptr ? n : static_cast<std::size_t>(some_[n]);
            visit(k, owned_[k]);
        }
    }

private:
    std::span<const int> owned_;
    const int* some_ = nullptr; ///< none: all rows
    std::size_t count_;
};

/// The rows that need nobody else's particles, and the others.
struct RowSplit {
    std::vector<int> inner;  ///< rows without a halo copy among their neighbours, ascending
    std::vector<int> border; ///< the others, ascending
    std::vector<int> halo;   ///< local indices of the halo copies, ascending

    /// \param is_owned 1 for an owned particle, 0 for a halo copy
    void find(const NeighbourList& list, const std::vector<std::uint8_t>& is_owned)
    {
        inner.clear();
        border.clear();
        halo.clear();
        for (std::size_t k = 0; k < list.rows(); ++k) {
            bool needs_others = false;
            list.for_each_block(k, [&](const NeighbourBlock& block) {
                for (int n = 0; n < block.count; ++n)
                    needs_others |= is_owned[static_cast<std::size_t>(block.base + block.offsets[n])] == 0;
            });
            (needs_others ? border : inner).push_back(static_cast<int>(k));
        }
        for (std::size_t i = 0; i < is_owned.size(); ++i)
            if (is_owned[i] == 0) halo.push_back(static_cast<int>(i));
    }
};

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/geometry.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace base {

/// Finds which of many boxes are near a point: boxes are entered into the cells of a cubic grid, kept in a hash table,
/// so
/// that a point is answered by looking at its one cell. Costs memory for each cell that a box covers.
template<int D> class BoxGrid {
public:
    /// \param cell_size [m], positive.
    explicit BoxGrid(double cell_size) : per_size_(1.0 / cell_size) {}

    void clear();
    /// Enters item `item`, whose box is `box`. Call build() after the last one.
    void add(int item, const Box<D>& box);
    void build();

    /// Items, ascending, whose boxes share a cell with x; those whose box contains x are certainly among them.
    std::span<const int> near(const Point<D>& x) const;

private:
    using Key = std::uint64_t;
    struct Entry {
        Key key;
        int item;
        auto operator<=>(const Entry&) const = default;
    };
    struct Slot {
        Key key = empty_;
        int begin = 0, end = 0;
    };
    static constexpr Key empty_ = ~Key{0};

    std::int64_t index(double x) const { return static_cast<std::int64_t>(std::floor(x * per_size_)); }
    static Key key(const std::array<std::int64_t, D>& cell);
    std::size_t slot_of(Key key) const;

    double per_size_;
    std::vector<Entry> entries_;
    std::vector<int> items_;
    std::vector<Slot> slots_;
};

} // namespace base

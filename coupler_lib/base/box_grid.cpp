// SPDX-License-Identifier: MIT
#include "coupler_lib/base/box_grid.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <bit>

namespace base {
namespace {

constexpr double most_cells = 1e7; // of one item; without the limit a run that has diverged hangs here

} // namespace

template<int D> void BoxGrid<D>::clear()
{
    entries_.clear();
    items_.clear();
    slots_.clear();
}

template<int D> void BoxGrid<D>::add(int item, const Box<D>& box)
{
    std::array<std::int64_t, D> low{}, high{};
    double cells = 1.0;
    for (std::size_t d = 0; d < D; ++d) {
        low[d] = index(box.low[static_cast<int>(d)]);
        high[d] = index(box.high[static_cast<int>(d)]);
        cells *= static_cast<double>(high[d] - low[d] + 1);
    }
    require(cells < most_cells, ExitCode::numerical_failure, "item ", item, " of a search grid reaches over ", cells,
            " cells: a moving wall has gone wild, or a wall is huge against the particle spacing");
    for (auto cell = low;;) {
        entries_.push_back({key(cell), item});
        std::size_t d = 0;
        while (d < D && ++cell[d] > high[d]) {
            cell[d] = low[d];
            ++d;
        }
        if (d == D) return;
    }
}

template<int D> void BoxGrid<D>::build()
{
    std::sort(entries_.begin(), entries_.end());
    items_.resize(entries_.size());
    slots_.assign(std::bit_ceil(2 * entries_.size() + 1), Slot{});
    for (std::size_t begin = 0, end = 0; begin < entries_.size(); begin = end) {
        while (end < entries_.size() && entries_[end].key == entries_[begin].key) {
            items_[end] = entries_[end].item;
            ++end;
        }
        slots_[slot_of(entries_[begin].key)] = {entries_[begin].key, static_cast<int>(begin), static_cast<int>(end)};
    }
}

template<int D> std::span<const int> BoxGrid<D>::near(const Point<D>& x) const
{
    if (slots_.empty()) return {};
    std::array<std::int64_t, D> cell{};
    for (std::size_t d = 0; d < D; ++d) cell[d] = index(x[static_cast<int>(d)]);
    const Slot& slot = slots_[slot_of(key(cell))];
    return {items_.data() + slot.begin, static_cast<std::size_t>(slot.end - slot.begin)};
}

template<int D> auto BoxGrid<D>::key(const std::array<std::int64_t, D>& cell) -> Key
{
    Key key = 0;
    for (std::size_t d = 0; d < D; ++d) key = (key << 21) | (static_cast<Key>(cell[d]) & ((Key{1} << 21) - 1));
    return key;
}

/// The slot that holds the key, or the free one where it would be entered (linear probing).
template<int D> std::size_t BoxGrid<D>::slot_of(Key key) const
{
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = (key * 0x9E3779B97F4A7C15ull >> 20) & mask;
    while (slots_[slot].key != empty_ && slots_[slot].key != key) slot = (slot + 1) & mask;
    return slot;
}

template class BoxGrid<2>;
template class BoxGrid<3>;

} // namespace base

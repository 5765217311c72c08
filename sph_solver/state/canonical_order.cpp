// SPDX-License-Identifier: MIT
#include "sph_solver/state/canonical_order.hpp"

#include <algorithm>

namespace sph {
namespace {

struct SortItem {
    CellKey cell;
    std::int64_t id;
    int index;

    friend bool operator<(const SortItem& a, const SortItem& b)
    {
        return a.cell != b.cell ? a.cell < b.cell : a.id < b.id;
    }
};

template<class T> void gather(std::vector<T>& column, const std::vector<SortItem>& order)
{
    std::vector<T> sorted(column.size());
    for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = column[static_cast<std::size_t>(order[k].index)];
    column.swap(sorted);
}

template<class T> void compress(std::vector<T>& column, const std::vector<std::uint8_t>& keep)
{
    std::size_t kept = 0;
    for (std::size_t k = 0; k < keep.size(); ++k) {
        if (keep[k] != 0) column[kept++] = column[k];
    }
    column.resize(kept);
}

template<int D> void list_owned(Particles<D>& particles)
{
    particles.owned.clear();
    for (std::size_t k = 0; k < particles.size(); ++k) {
        if (particles.is_owned[k] != 0) particles.owned.push_back(static_cast<int>(k));
    }
}

} // namespace

template<int D> std::vector<int> sort_canonically(Particles<D>& particles, const CellGrid<D>& grid)
{
    std::vector<SortItem> order(particles.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        order[k] = {grid.key_of(particles.position[k]), particles.id[k], static_cast<int>(k)};
    }
    if (!std::is_sorted(order.begin(), order.end())) {
        std::sort(order.begin(), order.end());
        for_each_field(particles, [&](const FieldInfo&, auto& column) { gather(column, order); });
        gather(particles.is_owned, order);
    }
    list_owned(particles);
    std::vector<int> new_index(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        new_index[static_cast<std::size_t>(order[k].index)] = static_cast<int>(k);
    }
    return new_index;
}

template<int D> void keep_particles(Particles<D>& particles, const std::vector<std::uint8_t>& keep)
{
    for_each_field(particles, [&](const FieldInfo&, auto& column) { compress(column, keep); });
    particles.own_all();
}

template<int D> void drop_halo(Particles<D>& particles)
{
    if (particles.owned.size() == particles.size()) return;
    keep_particles(particles, std::vector<std::uint8_t>(particles.is_owned));
}

template std::vector<int> sort_canonically(Particles<2>&, const CellGrid<2>&);
template std::vector<int> sort_canonically(Particles<3>&, const CellGrid<3>&);
template void keep_particles(Particles<2>&, const std::vector<std::uint8_t>&);
template void keep_particles(Particles<3>&, const std::vector<std::uint8_t>&);
template void drop_halo(Particles<2>&);
template void drop_halo(Particles<3>&);

} // namespace sph

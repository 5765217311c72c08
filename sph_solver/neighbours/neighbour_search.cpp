// SPDX-License-Identifier: MIT
#include "sph_solver/neighbours/neighbour_search.hpp"

#include <algorithm>
#include <cmath>

namespace sph {

template<int D>
NeighbourSearch<D>::NeighbourSearch(double support, double skin) : support_(support), skin_(skin), grid_(support + skin)
{}

/// Row after row, cell by cell: the runs of candidates are the same for all particles of a cell.
template<int D> void NeighbourSearch<D>::build(const Particles<D>& particles)
{
    const std::vector<int>& owned = particles.owned;
    find_cells(particles.position);
    points_.load(particles.position);
    list_.offsets.assign(owned.size() + 1, 0);
    built_at_.resize(owned.size());
    sweep_.fill(0);
    std::size_t count = 0;
    std::size_t k = 0;
    for (std::size_t cell = 0; cell < cell_keys_.size(); ++cell) {
        const int end = cell_begins_[cell + 1];
        if (k == owned.size() || owned[k] >= end) continue;
        const Runs runs = runs_around(cell_keys_[cell]);
        for (; k < owned.size() && owned[k] < end; ++k) {
            append_row(owned[k], runs, count);
            list_.offsets[k + 1] = count;
            built_at_[k] = particles.position[static_cast<std::size_t>(owned[k])];
        }
    }
    list_.indices.resize(count);
}

/// Ranges of equal cell in the sorted particles.
template<int D> void NeighbourSearch<D>::find_cells(const std::vector<Vec<D>>& position)
{
    cell_keys_.clear();
    cell_begins_.clear();
    for (std::size_t j = 0; j < position.size(); ++j) {
        const CellKey key = grid_.key_of(position[j]);
        if (!cell_keys_.empty() && cell_keys_.back() == key) continue;
        base::ensure(cell_keys_.empty() || cell_keys_.back() < key, "particles are in canonical order");
        cell_keys_.push_back(key);
        cell_begins_.push_back(static_cast<int>(j));
    }
    cell_begins_.push_back(static_cast<int>(position.size()));
}

/// The 3^D cells around one are 3^(D-1) rows along x, each a range of consecutive local indices. Cells are visited in
/// ascending order, so the search for each row goes on where it stopped for the cell before.
template<int D> auto NeighbourSearch<D>::runs_around(CellKey key) -> Runs
{
    const auto centre = CellGrid<D>::cell(key);
    Runs runs{};
    for (std::size_t row = 0; row < row_count; ++row) {
        auto first = centre;
        first[0] -= 1;
        first[1] += static_cast<int>(row % 3) - 1;
        if constexpr (D == 3) first[2] += static_cast<int>(row / 3) - 1;
        const CellKey low = CellGrid<D>::key(first);
        std::size_t& cell = sweep_[row];
        while (cell < cell_keys_.size() && cell_keys_[cell] < low) ++cell;
        std::size_t end = cell;
        while (end < cell_keys_.size() && cell_keys_[end] <= low + 2) ++end;
        runs[row] = {cell_begins_[cell], cell_begins_[end]};
    }
    return runs;
}

/// `indices` only grows here and is cut to size at the end: what the last list has left in it is written over.
template<int D> void NeighbourSearch<D>::append_row(int i, const Runs& runs, std::size_t& count)
{
    std::size_t room = count + selection_overhang;
    for (const auto& [begin, end] : runs) room += static_cast<std::size_t>(end - begin);
    if (list_.indices.size() < room) list_.indices.resize(room + room / 4);
    int* const first = list_.indices.data();
    int* out = first + count;
    for (const auto& [begin, end] : runs) out = points_.select(i, reach() * reach(), begin, end, out);
    count = static_cast<std::size_t>(out - first);
}

template<int D> void NeighbourSearch<D>::build(const Particles<D>& particles, const PairFilter<D>& filter)
{
    build(particles);
    std::size_t kept = 0;
    std::size_t read = 0;
    for (std::size_t k = 0; k < particles.owned.size(); ++k) {
        const Vec<D>& x_i = particles.position[static_cast<std::size_t>(particles.owned[k])];
        const std::size_t end = list_.offsets[k + 1];
        const bool all_pass = !filter.concerns(x_i);
        for (; read < end; ++read) {
            const int j = list_.indices[read];
            if (all_pass || filter.lets_pass(x_i, particles.position[static_cast<std::size_t>(j)]))
                list_.indices[kept++] = j;
        }
        list_.offsets[k + 1] = kept;
    }
    list_.indices.resize(kept);
}

template<int D> double NeighbourSearch<D>::largest_displacement(const Particles<D>& particles) const
{
    double largest = 0.0;
    for (std::size_t k = 0; k < built_at_.size(); ++k) {
        const Vec<D>& x = particles.position[static_cast<std::size_t>(particles.owned[k])];
        largest = std::max(largest, (x - built_at_[k]).squaredNorm());
    }
    return std::sqrt(largest);
}

template class NeighbourSearch<2>;
template class NeighbourSearch<3>;

} // namespace sph

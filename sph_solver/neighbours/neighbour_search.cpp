// SPDX-License-Identifier: MIT
#include "sph_solver/neighbours/neighbour_search.hpp"

#include <algorithm>
#include <cmath>

namespace sph {

template<int D>
NeighbourSearch<D>::NeighbourSearch(double support, double skin) : support_(support), skin_(skin), grid_(support + skin)
{}

template<int D> void NeighbourSearch<D>::build(const Particles<D>& particles)
{
    build(particles, {.concerns = [](const Vec<D>&) { return false; }, .lets_pass = {}});
}

/// Row after row, cell by cell: the runs of candidates are the same for all particles of a cell.
template<int D> void NeighbourSearch<D>::build(const Particles<D>& particles, const PairFilter<D>& filter)
{
    const std::vector<int>& owned = particles.owned;
    find_cells(particles.position);
    PointColumns<D> points;
    points.load(particles.position);
    list_.clear();
    built_at_.resize(owned.size());
    sweep_.fill(0);
    std::size_t k = 0;
    for (std::size_t cell = 0; cell < cell_keys_.size(); ++cell) {
        const int end = cell_begins_[cell + 1];
        if (k == owned.size() || owned[k] >= end) continue;
        const Runs runs = runs_around(cell_keys_[cell]);
        for (; k < owned.size() && owned[k] < end; ++k) {
            const Vec<D>& x = built_at_[k] = particles.position[static_cast<std::size_t>(owned[k])];
            find_row(owned[k], runs, points);
            if (filter.concerns(x))
                std::erase_if(
                    row_, [&](int j) { return !filter.lets_pass(x, particles.position[static_cast<std::size_t>(j)]); });
            list_.append(row_);
        }
    }
    list_.finish();
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

template<int D> void NeighbourSearch<D>::find_row(int i, const Runs& runs, const PointColumns<D>& points)
{
    std::size_t room = selection_overhang;
    for (const auto& [begin, end] : runs) room += static_cast<std::size_t>(end - begin);
    row_.resize(room);
    int* out = row_.data();
    for (const auto& [begin, end] : runs) out = points.select(i, reach() * reach(), begin, end, out);
    row_.resize(static_cast<std::size_t>(out - row_.data()));
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

// SPDX-License-Identifier: MIT
#include "sph_solver/neighbours/neighbour_search.hpp"

#include <algorithm>
#include <cmath>

namespace sph {

template<int D>
NeighbourSearch<D>::NeighbourSearch(double support, double skin) : support_(support), skin_(skin), grid_(support + skin)
{}

template<int D> void NeighbourSearch<D>::build(const Particles<D>& particles, const PairFilter<D>& filter)
{
    find_cells(particles.position);
    list_.offsets.assign(1, 0);
    list_.offsets.reserve(particles.owned.size() + 1);
    list_.indices.clear();
    built_at_.resize(particles.owned.size());
    sweep_.fill(0);
    CellKey current = ~CellKey{0};
    Runs runs{};
    for (std::size_t k = 0; k < particles.owned.size(); ++k) {
        const int i = particles.owned[k];
        const Vec<D>& x_i = particles.position[static_cast<std::size_t>(i)];
        const CellKey key = grid_.key_of(x_i);
        if (key != current) runs = runs_around(current = key);
        append_row(particles.position, i, runs);
        list_.offsets.push_back(list_.indices.size());
        built_at_[k] = x_i;
    }
    if (filter) apply_filter(particles, filter);
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

template<int D> void NeighbourSearch<D>::append_row(const std::vector<Vec<D>>& position, int i, const Runs& runs)
{
    std::size_t candidates = 0;
    for (const auto& [begin, end] : runs) candidates += static_cast<std::size_t>(end - begin);
    std::size_t count = list_.indices.size();
    list_.indices.resize(count + candidates);
    int* out = list_.indices.data();
    const Vec<D> x_i = position[static_cast<std::size_t>(i)];
    const double reach_squared = reach() * reach();
    for (const auto& [begin, end] : runs) {
        for (int j = begin; j < end; ++j) {
            out[count] = j;
            const double r_squared = (position[static_cast<std::size_t>(j)] - x_i).squaredNorm();
            count += static_cast<std::size_t>(r_squared < reach_squared) & static_cast<std::size_t>(j != i);
        }
    }
    list_.indices.resize(count);
}

template<int D> void NeighbourSearch<D>::apply_filter(const Particles<D>& particles, const PairFilter<D>& filter)
{
    std::size_t kept = 0;
    std::size_t read = 0;
    for (std::size_t k = 0; k < particles.owned.size(); ++k) {
        const Vec<D>& x_i = particles.position[static_cast<std::size_t>(particles.owned[k])];
        const std::size_t end = list_.offsets[k + 1];
        for (; read < end; ++read) {
            const int j = list_.indices[read];
            if (filter(x_i, particles.position[static_cast<std::size_t>(j)])) list_.indices[kept++] = j;
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

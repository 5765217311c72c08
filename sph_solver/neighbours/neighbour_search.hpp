// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/neighbours/close_points.hpp"
#include "sph_solver/neighbours/neighbour_list.hpp"
#include "sph_solver/state/cell_grid.hpp"

#include <array>
#include <utility>
#include <vector>

namespace sph {

/// Finds the neighbours of the owned particles and knows when its list has aged.
///
/// The skin is what the list reaches beyond the kernel's support 2 h: the list is complete as long as no two particles
/// have come closer by more than the skin, for which twice the largest displacement is the bound.
template<int D> class NeighbourSearch {
public:
    /// \param support kernel support 2 h [m], positive  \param skin [m], not negative
    NeighbourSearch(double support, double skin);

    [[nodiscard]] double reach() const { return support_ + skin_; }
    [[nodiscard]] double skin() const { return skin_; }
    /// The grid whose cells, `reach()` wide, give the canonical order.
    [[nodiscard]] const CellGrid<D>& grid() const { return grid_; }

    /// Makes the list anew. \pre particles in canonical order of `grid()`, halo copies complete within `reach()`.
    void build(const Particles<D>& particles);
    /// The same, and leaves out the pairs that `filter` does not let pass.
    void build(const Particles<D>& particles, const PairFilter<D>& filter);

    [[nodiscard]] const NeighbourList& list() const { return list_; }
    [[nodiscard]] bool empty() const { return built_at_.empty(); }

    /// Largest distance [m] that one of my particles has moved since the build, 0 without particles.
    /// The caller takes the maximum over the ranks, so that all rebuild together.
    [[nodiscard]] double largest_displacement(const Particles<D>& particles) const;

private:
    static constexpr std::size_t row_count = D == 2 ? 3 : 9;
    using Runs = std::array<std::pair<int, int>, row_count>; ///< local index ranges of three cells in a row

    void find_cells(const std::vector<Vec<D>>& position);
    [[nodiscard]] Runs runs_around(CellKey key);
    void find_row(int i, const Runs& runs, const PointColumns<D>& points);

    double support_;
    double skin_;
    CellGrid<D> grid_;
    NeighbourList list_;
    std::vector<int> row_;                       ///< the row that is being made
    std::vector<Vec<D>> built_at_;               ///< positions of the owned particles at the build
    std::vector<CellKey> cell_keys_;             ///< occupied cells, ascending
    std::vector<int> cell_begins_;               ///< first local index of each, and the end
    std::array<std::size_t, row_count> sweep_{}; ///< where the last search of each row ended
};

} // namespace sph

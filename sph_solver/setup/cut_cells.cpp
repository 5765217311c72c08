// SPDX-License-Identifier: MIT
#include "sph_solver/setup/cut_cells.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sph {

template<int D> CutCells<D>::CutCells(const base::Box<D>& bounds, double spacing, const char* what) : bounds_(bounds)
{
    std::int64_t count = 1;
    for (int d = 0; d < D; ++d) {
        const double length = bounds.high[d] - bounds.low[d];
        const auto cells = std::llround(length / spacing);
        base::require_input(cells > 0, what, " is ", length, " m long along axis ", d,
                            ", less than half a particle spacing (", spacing, " m)");
        cells_[static_cast<std::size_t>(d)] = cells;
        step_[d] = length / static_cast<double>(cells);
        count *= cells;
    }
    parts_.resize(static_cast<std::size_t>(count));
}

template<int D> std::int64_t CutCells<D>::index(const Cell& cell) const
{
    std::int64_t number = 0;
    for (std::size_t d = D; d-- > 0;) number = number * cells_[d] + cell[d];
    return number;
}

template<int D> void CutCells<D>::add(const Cell& cell, double volume, const Vec<D>& moment)
{
    Part& part = parts_[static_cast<std::size_t>(index(cell))];
    part.volume += volume;
    part.moment += moment;
}

template<int D> double CutCells<D>::volume() const
{
    return std::accumulate(parts_.begin(), parts_.end(), 0.0, [](double sum, const Part& p) { return sum + p.volume; });
}

template<int D> bool CutCells<D>::full_at(const Vec<D>& x) const
{
    Cell cell{};
    for (int d = 0; d < D; ++d) {
        const double place = std::floor((x[d] - bounds_.low[d]) / step_[d]);
        if (!(place >= 0.0 && place < static_cast<double>(cells(d)))) return false;
        cell[static_cast<std::size_t>(d)] = static_cast<std::int64_t>(place);
    }
    return parts_[static_cast<std::size_t>(index(cell))].volume > 0.999 * step_.prod();
}

template<int D> std::int64_t CutCells<D>::largest_neighbour(const std::vector<Part>& parts, std::int64_t cell) const
{
    std::int64_t best = cell, stride = 1;
    for (std::size_t d = 0; d < D; stride *= cells_[d++]) {
        const std::int64_t place = cell / stride % cells_[d];
        for (const std::int64_t step : {-1, 1}) {
            if (place + step < 0 || place + step >= cells_[d]) continue;
            const std::int64_t other = cell + step * stride;
            if (parts[static_cast<std::size_t>(other)].volume > parts[static_cast<std::size_t>(best)].volume)
                best = other;
        }
    }
    return best;
}

template<int D> std::vector<WaterPoint<D>> CutCells<D>::particles() const
{
    const double half = 0.5 * step_.prod();
    std::vector<Part> parts = parts_;
    std::vector<std::int64_t> slivers;
    for (std::size_t k = 0; k < parts.size(); ++k)
        if (parts[k].volume > 0.0 && parts[k].volume < half) slivers.push_back(static_cast<std::int64_t>(k));
    std::stable_sort(slivers.begin(), slivers.end(), [&](std::int64_t a, std::int64_t b) {
        return parts_[static_cast<std::size_t>(a)].volume < parts_[static_cast<std::size_t>(b)].volume;
    });
    for (const std::int64_t k : slivers) {
        Part& sliver = parts[static_cast<std::size_t>(k)];
        const std::int64_t target = largest_neighbour(parts, k);
        if (target == k || sliver.volume >= half) continue;
        parts[static_cast<std::size_t>(target)].volume += sliver.volume;
        parts[static_cast<std::size_t>(target)].moment += sliver.moment;
        sliver = {};
    }
    std::vector<WaterPoint<D>> points;
    for (const Part& part : parts)
        if (part.volume > 0.0) points.push_back({part.moment / part.volume, part.volume});
    return points;
}

template class CutCells<2>;
template class CutCells<3>;

} // namespace sph

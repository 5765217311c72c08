// SPDX-License-Identifier: MIT
#include "coupler_lib/base/stl_file.hpp"
#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/setup/cut_cells.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

constexpr std::int64_t lines_across =
    4; // vertical lines through a cell in each direction; along them lengths are exact

/// The surface seen along vertical lines through the columns of a lattice.
class Columns {
public:
    explicit Columns(const CutCells<3>& cells)
        : cells_(cells),
          count_{cells.cells(0) * lines_across, cells.cells(1) * lines_across},
          gap_{cells.step().x() / lines_across, cells.step().y() / lines_across},
          crossings_(static_cast<std::size_t>(count_[0] * count_[1]))
    {}

    void pierce(const base::Simplex<3>& triangle)
    {
        const base::Box<3> box = base::box_around<3>(triangle);
        std::array<std::int64_t, 2> first{}, last{};
        for (int d = 0; d < 2; ++d) {
            const auto a = static_cast<std::size_t>(d);
            first[a] = std::max<std::int64_t>(0, std::llround((box.low[d] - cells_.low()[d]) / gap_[a] - 0.5));
            last[a] =
                std::min<std::int64_t>(count_[a] - 1, std::llround((box.high[d] - cells_.low()[d]) / gap_[a] - 0.5));
        }
        for (std::int64_t j = first[1]; j <= last[1]; ++j)
            for (std::int64_t i = first[0]; i <= last[0]; ++i)
                if (const auto crossing = base::crossing_of_vertical(triangle, place(0, i), place(1, j)))
                    crossings_[static_cast<std::size_t>(j * count_[0] + i)].push_back(*crossing);
    }

    /// Gives the lattice what lies between going in and coming out. \param outward 1 if the normals point outwards, else -1.
    void fill(CutCells<3>& cells, int outward)
    {
        for (std::int64_t j = 0; j < count_[1]; ++j)
            for (std::int64_t i = 0; i < count_[0]; ++i) fill_line(cells, i, j, outward);
    }

private:
    double place(int axis, std::int64_t k) const
    {
        return cells_.low()[axis] + (static_cast<double>(k) + 0.5) * gap_[static_cast<std::size_t>(axis)];
    }

    void fill_line(CutCells<3>& cells, std::int64_t i, std::int64_t j, int outward)
    {
        auto& line = crossings_[static_cast<std::size_t>(j * count_[0] + i)];
        std::sort(line.begin(), line.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
        int winding = 0;
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            winding += outward * line[k].winding;
            if (winding > 0) fill_piece(cells, i, j, {line[k].z, line[k + 1].z});
        }
    }

    void fill_piece(CutCells<3>& cells, std::int64_t i, std::int64_t j, std::array<double, 2> z)
    {
        const double step = cells.step().z(), low = cells.low().z();
        const auto top = static_cast<double>(cells.cells(2) - 1);
        const auto first = static_cast<std::int64_t>(std::clamp(std::floor((z[0] - low) / step), 0.0, top));
        const auto last = static_cast<std::int64_t>(std::clamp(std::floor((z[1] - low) / step), 0.0, top));
        for (std::int64_t k = first; k <= last; ++k) {
            const double from = k == first ? z[0] : low + static_cast<double>(k) * step;
            const double to = k == last ? z[1] : low + static_cast<double>(k + 1) * step;
            const double volume = (to - from) * gap_[0] * gap_[1];
            cells.add({i / lines_across, j / lines_across, k}, volume,
                      volume * Vec<3>(place(0, i), place(1, j), 0.5 * (from + to)));
        }
    }

    const CutCells<3>& cells_;
    std::array<std::int64_t, 2> count_;
    std::array<double, 2> gap_;
    std::vector<std::vector<base::Crossing>> crossings_;
};

class StlWater final : public ListedWater<3> {
public:
    StlWater(std::vector<WaterPoint<3>> points, base::TriangleMesh surface, CutCells<3> cells)
        : ListedWater<3>(std::move(points)), surface_(std::move(surface)), cells_(std::move(cells))
    {}

    double top(const Vec<3>& up) const override
    {
        double highest = surface_.corners.front().dot(up);
        for (const auto& corner : surface_.corners) highest = std::max(highest, corner.dot(up));
        return highest;
    }

    bool contains(const Vec<3>& x) const override { return cells_.full_at(x); }

private:
    base::TriangleMesh surface_;
    CutCells<3> cells_;
};

} // namespace

std::unique_ptr<WaterBody<3>> make_stl_water(const WaterConfig& water, double spacing)
{
    base::TriangleMesh surface = base::read_stl(water.file, water.scale);
    base::require_closed(surface, "the water of '" + water.file + "'");
    base::Box<3> bounds;
    for (const auto& corner : surface.corners) bounds.include(corner);
    CutCells<3> cells(bounds, spacing, "the water of an STL file");
    const double volume = base::enclosed_volume(surface);
    Columns columns(cells);
    for (std::size_t k = 0; k < surface.triangles.size(); ++k) columns.pierce(surface.triangle(k));
    columns.fill(cells, volume > 0.0 ? 1 : -1);
    base::require_input(cells.volume() > 0.0, "the water of '", water.file, "' encloses nothing at this spacing (",
                        spacing, " m)");

    std::vector<WaterPoint<3>> points = cells.particles();
    const double correction = std::abs(volume) / cells.volume(); // the lines miss some of a curved surface
    for (auto& point : points) point.volume *= correction;
    return std::make_unique<StlWater>(std::move(points), std::move(surface), std::move(cells));
}

} // namespace sph

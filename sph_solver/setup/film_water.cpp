// SPDX-License-Identifier: MIT
#include "coupler_lib/base/ground.hpp"
#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/setup/water_body.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

/// A column of the lattice between the ground and the top.
template<int D> struct Column {
    Vec<D> foot = Vec<D>::Zero(); ///< its middle on the ground [m]
    double depth = 0;             ///< [m]
    double section = 0;           ///< [m^(D-1)]
};

template<int D> std::vector<Column<D>> columns_of(const WaterConfig& water, double spacing)
{
    constexpr int up = D - 1;
    const auto ground = base::make_height_file(water.file, D);
    std::array<std::int64_t, 2> cells{1, 1};
    std::array<double, 2> step{1, 1};
    for (std::size_t d = 0; d < up; ++d) {
        cells[d] = std::max<std::int64_t>(1, std::llround((water.high[d] - water.low[d]) / spacing));
        step[d] = (water.high[d] - water.low[d]) / static_cast<double>(cells[d]);
    }
    std::vector<Column<D>> columns;
    for (std::int64_t k = 0; k < cells[0] * cells[1]; ++k) {
        const std::array<std::int64_t, 2> cell{k % cells[0], k / cells[0]};
        Column<D> column;
        for (std::size_t d = 0; d < up; ++d)
            column.foot[static_cast<int>(d)] = water.low[d] + (static_cast<double>(cell[d]) + 0.5) * step[d];
        const double height = ground->at(column.foot[0], D == 3 ? column.foot[1] : 0.0).value;
        column.foot[up] = std::max(water.low[up], height);
        column.depth = water.high[up] - column.foot[up];
        column.section = step[0] * step[1];
        columns.push_back(column);
    }
    return columns;
}

template<int D> std::vector<WaterPoint<D>> points_of(const std::vector<Column<D>>& columns, double spacing)
{
    std::vector<WaterPoint<D>> points;
    for (const Column<D>& column : columns) {
        const auto layers = std::llround(column.depth / spacing);
        const double thickness = column.depth / static_cast<double>(std::max(layers, 1LL));
        for (std::int64_t layer = 0; layer < layers; ++layer)
            points.push_back({column.foot + (static_cast<double>(layer) + 0.5) * thickness * Vec<D>::Unit(D - 1),
                              column.section * thickness});
    }
    return points;
}

template<int D> class Film final : public ListedWater<D> {
public:
    Film(const WaterConfig& water, double spacing)
        : ListedWater<D>(points_of(columns_of<D>(water, spacing), spacing)),
          ground_(base::make_height_file(water.file, D)),
          box_(Eigen::Map<const Vec<D>>(water.low.data()), Eigen::Map<const Vec<D>>(water.high.data()))
    {
        base::require_input(this->count() > 0, water.file, ": the ground leaves no room for half a particle spacing (",
                            spacing, " m) of water below the film's top");
    }

    double top(const Vec<D>& up) const override
    {
        return (box_.min().array() * up.array()).max(box_.max().array() * up.array()).sum();
    }

    bool contains(const Vec<D>& x) const override
    {
        return (x.array() > box_.min().array()).all() && (x.array() < box_.max().array()).all() &&
               x[D - 1] > ground_->at(x[0], D == 3 ? x[1] : 0.0).value;
    }

private:
    std::unique_ptr<base::HeightField> ground_;
    Eigen::AlignedBox<double, D> box_;
};

} // namespace

template<int D> std::unique_ptr<WaterBody<D>> make_film(const WaterConfig& water, double spacing)
{
    return std::make_unique<Film<D>>(water, spacing);
}

template std::unique_ptr<WaterBody<2>> make_film(const WaterConfig&, double);
template std::unique_ptr<WaterBody<3>> make_film(const WaterConfig&, double);

} // namespace sph

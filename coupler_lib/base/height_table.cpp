// SPDX-License-Identifier: MIT
#include "coupler_lib/base/csv_table.hpp"
#include "coupler_lib/base/ground.hpp"
#include "coupler_lib/base/hdf5_reader.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>

namespace base {
namespace {

/// Equally spaced places along one direction.
struct Axis {
    double first = 0, step = 1;
    int count = 1;

    int place(double x) const { return count == 1 ? 0 : static_cast<int>(std::lround((x - first) / step)); }
};

Axis axis_of(std::vector<double> values, const std::string& path, const char* name)
{
    std::ranges::sort(values);
    const double extent = values.back() - values.front();
    const auto same = [&](double a, double b) { return std::abs(a - b) <= 1e-6 * extent; };
    values.erase(std::unique(values.begin(), values.end(), same), values.end());
    require_input(values.size() >= 2, path, ": the heights need two places along ", name, " at least");
    Axis axis{values.front(), extent / static_cast<double>(values.size() - 1), static_cast<int>(values.size())};
    for (std::size_t k = 0; k < values.size(); ++k)
        require_input(std::abs(values[k] - axis.first - static_cast<double>(k) * axis.step) <= 1e-4 * axis.step, path,
                      ": the places along ", name, " are not equally spaced, at ", values[k], " m");
    return axis;
}

/// Weights of four neighbours at t between the second and the third, with first and second derivatives by t.
struct Weights {
    std::array<double, 4> value, slope, curvature;

    explicit Weights(double t)
        : value{0.5 * t * (-1 + t * (2 - t)), 1 + 0.5 * t * t * (-5 + 3 * t), 0.5 * t * (1 + t * (4 - 3 * t)),
                0.5 * t * t * (t - 1)},
          slope{0.5 * (-1 + t * (4 - 3 * t)), 0.5 * t * (-10 + 9 * t), 0.5 * (1 + t * (8 - 9 * t)),
                0.5 * t * (3 * t - 2)},
          curvature{2 - 3 * t, -5 + 9 * t, 4 - 9 * t, 3 * t - 1}
    {}
};

class HeightTable final : public HeightField {
public:
    HeightTable(const CsvTable& table, int dimension) : x_(axis_of(table.column("x"), table.path, "x"))
    {
        const auto& heights = table.column("height");
        if (dimension == 3) y_ = axis_of(table.column("y"), table.path, "y");
        const auto places = static_cast<std::size_t>(x_.count) * static_cast<std::size_t>(y_.count);
        require_input(heights.size() == places, table.path, ": ", heights.size(), " heights are no lattice of ",
                      x_.count, " x ", y_.count, " places");
        heights_.assign(places, std::nan(""));
        for (std::size_t k = 0; k < places; ++k) {
            const double y = dimension == 3 ? table.column("y")[k] : 0;
            heights_[index(x_.place(table.column("x")[k]), y_.place(y))] = heights[k];
        }
        for (const double h : heights_)
            require_input(std::isfinite(h), table.path,
                          ": a place of the lattice has no height, or another one has two");
    }

    Height at(double x, double y) const override
    {
        const auto [i, wx] = along(x_, x);
        const auto [j, wy] = along(y_, y);
        Height h;
        for (int b = 0; b < 4; ++b)
            for (int a = 0; a < 4; ++a) {
                const double z =
                    heights_[index(std::clamp(i + a - 1, 0, x_.count - 1), std::clamp(j + b - 1, 0, y_.count - 1))];
                h.value += wx.value[a] * wy.value[b] * z;
                h.slope[0] += wx.slope[a] * wy.value[b] * z / x_.step;
                h.slope[1] += wx.value[a] * wy.slope[b] * z / y_.step;
                h.curvature[0] += wx.curvature[a] * wy.value[b] * z / (x_.step * x_.step);
                h.curvature[1] += wx.slope[a] * wy.slope[b] * z / (x_.step * y_.step);
                h.curvature[2] += wx.value[a] * wy.curvature[b] * z / (y_.step * y_.step);
            }
        return h;
    }

private:
    static std::pair<int, Weights> along(const Axis& axis, double x)
    {
        const double s = std::clamp((x - axis.first) / axis.step, -2.0, axis.count + 1.0);
        const double cell = std::floor(s);
        return {static_cast<int>(cell), Weights(s - cell)};
    }
    std::size_t index(int i, int j) const { return static_cast<std::size_t>(i + x_.count * j); }

    Axis x_, y_;
    std::vector<double> heights_;
};

/// An HDF5 file's heights as a table of one row for each place.
CsvTable read_lattice(const std::string& path, int dimension)
{
    const Hdf5Reader file(path);
    const auto read = [&](const char* name) {
        require_input(file.has(name), path, ": no dataset '", name, "'; heights need x, ", dimension == 3 ? "y, " : "",
                      "and height");
        return file.rows(name);
    };
    const Hdf5Rows x = read("x"), y = dimension == 3 ? read("y") : Hdf5Rows{{0.0}, 1, 1}, height = read("height");
    require_input(height.rows == x.values.size() && height.columns == y.values.size(), path, ": height has ",
                  height.rows, " x ", height.columns, " entries, the places are ", x.values.size(), " along x and ",
                  y.values.size(), " along y");
    CsvTable table{path, {"x[m]", "y[m]", "height[m]"}, {{}, {}, height.values}};
    for (const double at_x : x.values)
        for (const double at_y : y.values) {
            table.columns[0].push_back(at_x);
            table.columns[1].push_back(at_y);
        }
    return table;
}

} // namespace

std::unique_ptr<HeightField> make_height_table(const std::string& path, int dimension)
{
    const bool hdf5 = path.ends_with(".h5") || path.ends_with(".hdf5");
    return std::make_unique<HeightTable>(hdf5 ? read_lattice(path, dimension) : read_csv(path), dimension);
}

} // namespace base

// SPDX-License-Identifier: MIT
#include "sph_solver/config/wall_config.hpp"

#include "coupler_lib/base/ground.hpp"
#include "coupler_lib/base/stl_file.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sph {
namespace {

void require_numbers(const std::vector<double>& numbers, std::size_t count, const WallConfig& wall, const char* key)
{
    base::require_input(numbers.size() == count, "wall \"", wall.name, "\": ", key, " has ", numbers.size(),
                        " numbers, ", count, " are needed");
}

void add_polyline(WallShape& result, const WallConfig& wall)
{
    base::require_input(wall.points.size() >= 2, "wall \"", wall.name,
                        "\": a polyline needs two points at least, points = "
                        "[[x, y], ...]; it has ",
                        wall.points.size());
    for (const auto& point : wall.points) {
        require_numbers(point, 2, wall, "a point of the polyline");
        result.vertices.insert(result.vertices.end(), point.begin(), point.end());
    }
    const int count = static_cast<int>(wall.points.size());
    for (int a = 0; a + 1 < count; ++a) result.facets.push_back({a, a + 1, -1, -1});
    if (wall.closed) result.facets.push_back({count - 1, 0, -1, -1});
}

/// A polyline in the plane becomes a wall of quadrilaterals a, b, b + dz, a + dz between two depths z: their normal
/// (b - a) x dz = dz (t_y, -t_x, 0) is the one of the polyline.
void extrude(WallShape& result, const std::vector<double>& depth)
{
    std::vector<double> vertices;
    const auto count = static_cast<int>(result.vertices.size() / 2);
    for (const double z : depth) {
        for (int v = 0; v < count; ++v) {
            vertices.insert(vertices.end(), {result.vertices[static_cast<std::size_t>(2 * v)],
                                             result.vertices[static_cast<std::size_t>(2 * v + 1)], z});
        }
    }
    result.vertices.swap(vertices);
    for (auto& facet : result.facets) facet = {facet[0], facet[1], facet[1] + count, facet[0] + count};
}

bool is_open(const WallConfig& wall, const std::string& side)
{
    return std::find(wall.open.begin(), wall.open.end(), side) != wall.open.end();
}

/// The inside of a rectangle, run through clockwise, so that the fluid inside is on the right.
void add_box_2d(WallShape& result, const WallConfig& wall)
{
    const auto &a = wall.low, &b = wall.high;
    result.vertices = {a[0], a[1], a[0], b[1], b[0], b[1], b[0], a[1]};
    const std::array<const char*, 4> sides = {"left", "top", "right", "bottom"};
    for (int s = 0; s < 4; ++s) {
        if (!is_open(wall, sides[static_cast<std::size_t>(s)])) result.facets.push_back({s, (s + 1) % 4, -1, -1});
    }
}

/// The inside of a cuboid: vertex number x + 2 y + 4 z, each face counterclockwise seen from inside.
void add_box_3d(WallShape& result, const WallConfig& wall)
{
    for (int v = 0; v < 8; ++v) {
        for (std::size_t d = 0; d < 3; ++d) result.vertices.push_back(((v >> d) & 1) != 0 ? wall.high[d] : wall.low[d]);
    }
    struct Face {
        const char* side;
        std::array<int, 4> corners;
    };
    const std::array<Face, 6> faces = {{{"left", {0, 2, 6, 4}},
                                        {"right", {1, 5, 7, 3}},
                                        {"front", {0, 4, 5, 1}},
                                        {"back", {2, 3, 7, 6}},
                                        {"bottom", {0, 1, 3, 2}},
                                        {"top", {4, 6, 7, 5}}}};
    for (const Face& face : faces) {
        if (!is_open(wall, face.side)) result.facets.push_back(face.corners);
    }
}

void add_box(WallShape& result, const WallConfig& wall)
{
    const auto dimension = static_cast<std::size_t>(result.dimension);
    require_numbers(wall.low, dimension, wall, "low");
    require_numbers(wall.high, dimension, wall, "high");
    for (std::size_t d = 0; d < dimension; ++d) {
        base::require_input(wall.low[d] < wall.high[d], "wall \"", wall.name, "\": low (", wall.low[d],
                            " m) is not below high (", wall.high[d], " m) along axis ", d);
    }
    if (result.dimension == 2) return add_box_2d(result, wall);
    add_box_3d(result, wall);
}

void add_stl(WallShape& result, const WallConfig& wall)
{
    base::require_input(result.dimension == 3, "wall \"", wall.name, "\": an STL file is a shape in 3D");
    base::require_input(!wall.file.empty(), "wall \"", wall.name, "\": the shape stl needs a file");
    const base::TriangleMesh mesh = base::read_stl(wall.file, wall.unit);
    for (const auto& corner : mesh.corners)
        result.vertices.insert(result.vertices.end(), {corner.x(), corner.y(), corner.z()});
    for (const auto& [a, b, c] : mesh.triangles)
        result.facets.push_back(wall.flip ? std::array{a, c, b, -1} : std::array{a, b, c, -1});
}

/// The surface of a ground as a lattice over low..high: segments, or quadrilaterals, in 2D run through from high x to low
/// x, so that the solid is below.
void add_ground(WallShape& result, const WallConfig& wall)
{
    base::require_input(!wall.file.empty(), "wall \"", wall.name, "\": a ground needs a file of heights");
    base::require_input(wall.size > 0, "wall \"", wall.name, "\": a ground needs the size of its facets [m]");
    const auto along = static_cast<std::size_t>(result.dimension - 1);
    require_numbers(wall.low, along, wall, "low");
    require_numbers(wall.high, along, wall, "high");
    const auto height = base::make_height_file(wall.file, result.dimension);
    std::array<int, 2> cells{1, 0};
    std::array<double, 2> step{};
    for (std::size_t d = 0; d < along; ++d) {
        const double extent = wall.high[d] - wall.low[d];
        base::require_input(extent > 0, "wall \"", wall.name, "\": low is not below high along axis ", d);
        cells[d] = std::max(1, static_cast<int>(std::lround(extent / wall.size)));
        step[d] = extent / cells[d];
    }
    for (int j = 0; j <= cells[1]; ++j)
        for (int i = 0; i <= cells[0]; ++i) {
            const double x = wall.low[0] + i * step[0], y = along == 2 ? wall.low[1] + j * step[1] : 0.0;
            result.vertices.push_back(x);
            if (along == 2) result.vertices.push_back(y);
            result.vertices.push_back(height->at(x, y).value);
        }
    const int row = cells[0] + 1;
    for (int i = 0; along == 1 && i < cells[0]; ++i) result.facets.push_back({i + 1, i, -1, -1});
    for (int j = 0; j < cells[1]; ++j)
        for (int i = 0; i < cells[0]; ++i) {
            const int v = i + row * j;
            result.facets.push_back({v, v + 1, v + row + 1, v + row});
        }
}

void require_extent(const WallShape& wall)
{
    const auto dimension = static_cast<std::size_t>(wall.dimension);
    for (const auto& facet : wall.facets) {
        double length_squared = 0.0;
        for (std::size_t d = 0; d < dimension; ++d) {
            const auto at = [&](int v) { return wall.vertices[static_cast<std::size_t>(v) * dimension + d]; };
            length_squared += std::pow(at(facet[1]) - at(facet[0]), 2);
        }
        base::require_input(length_squared > 0.0, "wall \"", wall.name, "\": points ", facet[0] + 1, " and ",
                            facet[1] + 1, " are the same; remove one");
    }
}

base::Table<WallMotionConfig> motion_table()
{
    return base::Table<WallMotionConfig>("prescribed motion of the wall from its place in the file")
        .key("translation", &WallMotionConfig::translation, {.unit = "m", .doc = "displacement, formulas of t"})
        .key("table", &WallMotionConfig::table,
             {.doc =
                  "CSV file with the columns t[s], x[m], y[m] (, z[m]) of the displacement; a spline goes through it"})
        .key("rotation", &WallMotionConfig::rotation,
             {.unit = "rad", .doc = "angle, formula of t, counterclockwise about the axis"})
        .key("centre", &WallMotionConfig::centre, {.unit = "m", .doc = "point of the axis, translated with the wall"})
        .key("axis", &WallMotionConfig::axis, {.doc = "direction of the axis (3D)"});
}

} // namespace

base::Table<WallConfig> wall_table()
{
    return base::Table<WallConfig>("a rigid wall; the order of its points says where the solid is: left of a -> b")
        .key("name", &WallConfig::name, {.doc = "name in messages and outputs", .required = true})
        .key(
            "shape", &WallConfig::shape,
            {.doc =
                 "polyline: through points; box: the inside of low..high; stl: triangles of a file (3D); ground: below "
                 "the heights of a file, which the solid's contact may read too",
             .choices = {"polyline", "box", "stl", "ground"}})
        .key("points", &WallConfig::points, {.unit = "m", .doc = "corners [[x, y], ...] of a polyline"})
        .key("closed", &WallConfig::closed, {.doc = "join the last point to the first"})
        .key("low", &WallConfig::low,
             {.unit = "m", .doc = "lowest corner of a box; ground: where it begins, [x] or [x, y]"})
        .key("high", &WallConfig::high, {.unit = "m", .doc = "highest corner of a box; ground: where it ends"})
        .key("open", &WallConfig::open,
             {.doc = "sides of a box without a wall (2D: y is up; 3D: z is up)",
              .choices = {"left", "right", "bottom", "top", "front", "back"}})
        .key("depth", &WallConfig::depth, {.unit = "m", .doc = "3D polyline: lowest and highest z"})
        .key("file", &WallConfig::file,
             {.doc = "stl: its normals point into the water; ground: CSV with x[m], (y[m],) height[m] on a regular "
                     "lattice, "
                     "HDF5, or TOML with height = \"FORMULA of x, y\""})
        .key("unit", &WallConfig::unit, {.unit = "m", .doc = "length of one unit of the STL file", .positive = true})
        .key("flip", &WallConfig::flip, {.doc = "turn the triangles over: the water is inside of the STL body"})
        .key("size", &WallConfig::size, {.unit = "m", .doc = "ground: length of its facets", .min = 0})
        .key("slip", &WallConfig::slip, {.doc = "water slips along the wall; false: it sticks to it"})
        .table("motion", &WallConfig::motion, motion_table());
}

void check_motion(const WallConfig& wall, int dimension)
{
    const WallMotionConfig& motion = wall.motion;
    const auto count = static_cast<std::size_t>(dimension);
    base::require_input(motion.translation.empty() || motion.table.empty(), "wall \"", wall.name,
                        "\": its motion has a translation and a table; give one of them");
    base::require_input(motion.translation.empty() || motion.translation.size() == count, "wall \"", wall.name,
                        "\": motion.translation has ", motion.translation.size(), " formulas, ", count, " are needed");
    if (motion.rotation.text.empty()) return;
    require_numbers(motion.centre, count, wall, "motion.centre");
    require_numbers(motion.axis, 3, wall, "motion.axis");
    double square = 0.0;
    for (const double component : motion.axis) square += component * component;
    base::require_input(square > 0.0, "wall \"", wall.name, "\": motion.axis has no length");
    base::require_input(dimension == 3 || (motion.axis[0] == 0.0 && motion.axis[1] == 0.0), "wall \"", wall.name,
                        "\": in 2D a wall turns about the z axis only");
}

WallShape wall_shape(const WallConfig& wall, int dimension)
{
    WallShape result;
    result.name = wall.name;
    result.dimension = dimension;
    const bool has_points = !wall.points.empty(), has_box = !wall.low.empty() || !wall.high.empty();
    const bool ground = wall.shape == "ground";
    base::require_input((wall.shape == "polyline" || !has_points) && (wall.shape == "box" || ground || !has_box) &&
                            (wall.shape == "stl" || ground || wall.file.empty()),
                        "wall \"", wall.name,
                        "\": a box has low and high, a polyline has points, stl has a file, a ground low, high and a "
                        "file; this one mixes them");
    if (wall.shape == "box") {
        add_box(result, wall);
    } else if (ground) {
        add_ground(result, wall);
    } else if (wall.shape == "stl") {
        add_stl(result, wall);
    } else {
        add_polyline(result, wall);
        if (dimension == 3) {
            require_numbers(wall.depth, 2, wall, "depth");
            base::require_input(wall.depth[0] < wall.depth[1], "wall \"", wall.name, "\": depth = [", wall.depth[0],
                                ", ", wall.depth[1], "] m: the lowest z comes first");
            extrude(result, wall.depth);
        }
        require_extent(result);
    }
    return result;
}

} // namespace sph

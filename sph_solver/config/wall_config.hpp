// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/config.hpp"
#include "coupler_lib/base/expression.hpp"

#include <array>
#include <string>
#include <vector>

namespace sph {

/// motion = {...} of a wall: how it leaves the place that it has in the file.
struct WallMotionConfig {
    std::vector<base::Formula> translation = {};
    std::string table = {};
    base::Formula rotation = {};
    std::vector<double> centre = {};
    std::vector<double> axis = {0.0, 0.0, 1.0};

    bool moves() const { return !translation.empty() || !table.empty() || !rotation.text.empty(); }
};

/// [[walls]]: a rigid wall as written in the file.
struct WallConfig {
    std::string name = {};
    std::string shape = "polyline";
    std::vector<std::vector<double>> points = {};
    bool closed = false;
    std::vector<double> low = {};
    std::vector<double> high = {};
    std::vector<std::string> open = {};
    std::vector<double> depth = {};
    std::string file = {};
    double unit = 1.0;
    bool flip = false;
    double size = 0.0;
    bool slip = true;
    WallMotionConfig motion = {};
};

base::Table<WallConfig> wall_table();

/// Checks the motion of a wall for itself: lengths, contradictions. Throws Error(bad_input), naming the wall.
void check_motion(const WallConfig& wall, int dimension);

/// A wall as facets, in the convention of the coupling interface: the outward normal points from the solid into the
/// fluid. 2D: segments (a, b), n = (t_y, -t_x) with t = b - a, the solid on the left; 3D: quadrilaterals,
/// counterclockwise seen from the fluid. Unused corners are -1.
struct WallShape {
    std::string name = {};
    int dimension = 2;
    std::vector<double> vertices;           ///< points * dimension [m]
    std::vector<std::array<int, 4>> facets; ///< indices of vertices
};

/// Facets of a wall. Throws Error(bad_input), naming the wall, for points of the wrong dimension, missing or
/// contradictory keys and facets of no extent.
WallShape wall_shape(const WallConfig& wall, int dimension);

} // namespace sph

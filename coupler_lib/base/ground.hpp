// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/expression.hpp"
#include "coupler_lib/base/triangle_mesh.hpp"

#include <Eigen/Core>

#include <memory>

/// \file
/// Rigid grounds. In 2D the ground lies along x and the height is y; in 3D it lies along x and y and the height is z. Third
/// components are zero in 2D. Lengths in metres.
namespace base {

/// Where a point is to a ground, and how that changes as the point moves. The derivatives are exact for the gap and the
/// normal as they stand here, so that Newton's method converges quadratically with them.
struct GroundPoint {
    double gap = 0;                                         ///< negative inside the ground [m]
    Eigen::Vector3d gap_slope = Eigen::Vector3d::Zero();    ///< d gap/dx
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();       ///< unit normal n out of the ground
    Eigen::Matrix3d normal_slope = Eigen::Matrix3d::Zero(); ///< dn/dx [1/m]
};

/// A rigid surface with a solid side below it.
class Ground {
public:
    virtual ~Ground() = default;
    virtual GroundPoint at(const Eigen::Vector3d& x) const = 0;
};

/// gap = n . (x - point). \throws Error bad_input for a normal of no length.
std::unique_ptr<Ground> make_plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

/// Height h over the plane with its derivatives.
struct Height {
    double value = 0;                  ///< h [m]
    std::array<double, 2> slope{};     ///< h_x, h_y
    std::array<double, 3> curvature{}; ///< h_xx, h_xy, h_yy [1/m]
};

/// A height h(x) (2D) or h(x, y) (3D), smooth enough for second derivatives.
class HeightField {
public:
    virtual ~HeightField() = default;
    virtual Height at(double x, double y) const = 0;
};

/// The ground below z = h(x, y). With G = z - h and m = grad G:
///
///     gap = G/|m|,   n = m/|m|
///
/// which is the distance to the tangent plane under the point: equal to the distance to the ground up to terms of
/// gap^2 times the curvature, and exact where it vanishes.
std::unique_ptr<Ground> make_height_ground(std::unique_ptr<HeightField> height, int dimension);

/// A formula of x (and y in 3D); derivatives by central differences of fourth order over `step` [m].
std::unique_ptr<HeightField> make_height_formula(const Formula& formula, int dimension, double step);

/// Heights on a regular lattice: cubic convolution between the points (R. G. Keys, IEEE Trans. ASSP 29 (1981) 1153-1160),
/// which has continuous slopes; outside, the border's height. A CSV file has the columns x[m], (y[m],) height[m] in any
/// order; an HDF5 file (.h5, .hdf5) the datasets x, (y,) of the places along each axis and height, a row for each x.
/// \throws Error bad_input for points that are no full lattice of at least 2 a direction.
std::unique_ptr<HeightField> make_height_table(const std::string& path, int dimension);

/// A height that several programs read from one file: a table as above, or a formula in a TOML file (.toml) with the keys
/// height = "FORMULA of x, y" [m] and derivative_step [m], 1e-5 unless given.
std::unique_ptr<HeightField> make_height_file(const std::string& path, int dimension);

/// Triangles whose normals point out of the ground, closed or open: the signed distance to the nearest of them. Around
/// convex edges and corners the ground is rounded as the distance is, so that the normal is continuous outside; a point
/// that comes nearest to the rim of an open surface is beyond it and touches nothing.
/// \param what begins messages. \throws Error bad_input for an edge that three triangles share, or no triangle.
std::unique_ptr<Ground> make_surface_ground(TriangleMesh mesh, const std::string& what);

/// The same in 2D, from a CSV file with the columns x[m], y[m]: points along a line that has the ground on its right.
std::unique_ptr<Ground> make_polyline_ground(const std::string& path);

} // namespace base

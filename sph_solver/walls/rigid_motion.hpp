// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/time_function.hpp"
#include "sph_solver/numerics/vector.hpp"

#include <array>

namespace sph {

/// Where a rigid body is at one instant, as a map of the points X of its place in the file.
template<int D> struct RigidPlace {
    Mat<D> turn = Mat<D>::Identity();     ///< R
    Mat<D> spin = Mat<D>::Zero();         ///< dR/dt [1/s]
    Mat<D> spin_rate = Mat<D>::Zero();    ///< d2R/dt2 [1/s^2]
    Vec<D> centre = Vec<D>::Zero();       ///< c [m]
    Vec<D> displacement = Vec<D>::Zero(); ///< d [m]
    Vec<D> velocity = Vec<D>::Zero();     ///< of c [m/s]
    Vec<D> acceleration = Vec<D>::Zero(); ///< of c [m/s^2]

    Vec<D> position(const Vec<D>& x) const { return centre + displacement + turn * (x - centre); }
    Vec<D> velocity_of(const Vec<D>& x) const { return velocity + spin * (x - centre); }
    Vec<D> acceleration_of(const Vec<D>& x) const { return acceleration + spin_rate * (x - centre); }
};

/// Prescribed motion of a rigid body: a translation d(t), and a rotation by the angle theta(t) about a point that moves
/// with it,
///
///     x(t) = c + d + R (X - c),   R = I + sin(theta) K + (1 - cos(theta)) K K,
///     dR/dt = theta' K R,   d2R/dt2 = (theta'' K + theta'^2 K K) R,
///
/// with K v = axis x v (2D: a quarter turn counterclockwise). Velocity and acceleration are the exact derivatives of what
/// the time functions say.
template<int D> struct RigidMotion {
    std::array<base::TimeFunction, D> translation; ///< d [m]; empty functions stand still
    base::TimeFunction rotation;                   ///< theta [rad]; empty: none
    Vec<D> centre = Vec<D>::Zero();                ///< c [m]
    Vec<3> axis = Vec<3>(0, 0, 1);                 ///< 3D, unit length

    RigidPlace<D> at(double t) const;
};

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

/// \file
/// How the face between two particles moves: the freedom of the arbitrary Lagrangian-Eulerian form. Velocities along n,
/// relative to the mean (v_i + v_j)/2 . n of the pair; u is the Riemann solution's.
///
///     dm_i/dt = -sum S rho_e (u - u_face),     dw_i/dt = w_i div v + sum S u_face
///
/// Mass crosses the face with the first difference; what the face sweeps goes from one volume to the other.
namespace sph {

/// What crosses a face.
template<class T> struct FaceTransport {
    T relative; ///< u - u_face [m/s]
    T dilation; ///< what the volume of i gains for each unit of S as the fluid expands [m/s]
    T swept;    ///< what it gains beside that, from its neighbour [m/s]
};

/// The shifting velocities of a pair along n.
template<class T> struct FaceShift {
    T mean{};      ///< (v_s,i + v_s,j)/2 . n [m/s]
    T half_jump{}; ///< (v_s,j - v_s,i)/2 . n [m/s]
};

/// Key "mean": faces move with the mean velocity of their pair, and mass is exchanged (Vila's scheme, the default).
struct MeanMotion {
    static constexpr bool exchanges_mass = true, dilates = false, shifts = false;
    template<class T> FaceTransport<T> operator()(T u, const FaceShift<T>&) const { return {u, T{}, T{}}; }
};

/// Key "fluid": faces move with the fluid, u_face = u. No mass is exchanged, each particle keeps its own; volume is.
struct FluidMotion {
    static constexpr bool exchanges_mass = false, dilates = true, shifts = false;
    template<class T> FaceTransport<T> operator()(T u, const FaceShift<T>&) const { return {T{}, u, T{}}; }
};

/// Key "shifted": particles move with v + v_s, where v_s evens out their distances (operators/shifting.hpp), and faces
/// with the mean of that; what the particles leave behind crosses the faces.
struct ShiftedMotion {
    static constexpr bool exchanges_mass = true, dilates = false, shifts = true;
    double beta = 100.0; ///< strength of the shifting [-]

    template<class T> FaceTransport<T> operator()(T u, const FaceShift<T>& shift) const
    {
        return {u - shift.mean, T{}, shift.half_jump};
    }
};

/// The motion that a run uses, chosen in setup.
using FaceMotion = std::variant<MeanMotion, FluidMotion, ShiftedMotion>;

} // namespace sph

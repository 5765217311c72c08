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
    T sweep;    ///< u_face [m/s]
};

/// Key "mean": faces move with the mean velocity of their pair, and mass is exchanged (Vila's scheme, the default).
struct MeanMotion {
    static constexpr bool exchanges_mass = true, sweeps_volume = false;
    template<class T> FaceTransport<T> operator()(T u) const { return {u, T{}}; }
};

/// Key "fluid": faces move with the fluid, u_face = u. No mass is exchanged, each particle keeps its own; volume is.
struct FluidMotion {
    static constexpr bool exchanges_mass = false, sweeps_volume = true;
    template<class T> FaceTransport<T> operator()(T u) const { return {T{}, u}; }
};

/// The motion that a run uses, chosen in setup.
using FaceMotion = std::variant<MeanMotion, FluidMotion>;

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/vector.hpp"
#include "sph_solver/state/field.hpp"

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace sph {

/// The fluid's particles on this rank: mine (owned) and copies of others' (halo), interleaved in ONE canonical order:
/// cell of a grid with a fixed origin, then global id. The order does not depend on who owns what, so that a sum over
/// neighbours in ascending local index has the same terms in the same order on any number of ranks.
///
/// Columns have `size()` entries. `owned` lists the local indices of my particles, ascending; loops that write
/// results run over it, loops that read neighbours may touch any index.
template<int D> struct Particles {
    static constexpr int dimension = D;

    // conserved
    std::vector<std::int64_t> id; ///< global number, fixed for life
    std::vector<Vec<D>> position; ///< x [m]
    std::vector<double> volume;   ///< w [m^D]
    std::vector<double> mass;     ///< m [kg], 2D [kg/m]
    std::vector<Vec<D>> momentum; ///< P = m v [kg m/s], 2D [kg/s]

    // derived on every local particle from the conserved fields
    std::vector<Vec<D>> velocity;    ///< v = P / m [m/s]
    std::vector<double> density;     ///< rho = m / w [kg/m^3]
    std::vector<double> pressure;    ///< p(rho) [Pa]
    std::vector<double> sound_speed; ///< c(rho) [m/s]

    // derived on owned particles by a neighbour sum, then sent to the halo copies
    std::vector<Vec<D>> density_gradient;  ///< grad rho [kg/m^4]
    std::vector<Mat<D>> velocity_gradient; ///< (grad v)(a, b) = dv_a / dx_b [1/s]
    std::vector<Mat<D>> renormaliser;      ///< K of the pair areas (numerics/pair_area.hpp) [-]
    std::vector<Vec<D>> shift;             ///< velocity of the particle beside that of the fluid in it [m/s]

    // ownership
    std::vector<int> owned;             ///< local indices of my particles, ascending
    std::vector<std::uint8_t> is_owned; ///< 1 for mine, 0 for a halo copy

    [[nodiscard]] std::size_t size() const { return id.size(); }

    /// Gives every column `count` entries (ownership is left to the caller).
    void resize(std::size_t count);

    /// Declares all `size()` particles mine: the state of a run on one rank.
    void own_all();
};

/// Time derivatives of the conserved fields, one entry for each local particle, filled for owned ones.
/// (The position's derivative is velocity + shift.)
template<int D> struct Rates {
    std::vector<double> volume;   ///< dw/dt [m^D/s]
    std::vector<double> mass;     ///< dm/dt [kg/s]
    std::vector<Vec<D>> momentum; ///< dP/dt [N]

    /// Zeroes all rates for `count` local particles.
    void reset(std::size_t count);
};

/// The solver's one field table: allocation, migration, halo exchange, checkpoints and the attributes in output files
/// are driven by it. A field added here is carried everywhere.
template<int D> constexpr auto field_table()
{
    using P = Particles<D>;
    using enum Role;
    return std::make_tuple(
        Field{FieldInfo{"id", "i", "-", "-", "global particle number", conserved}, &P::id},
        Field{FieldInfo{"position", "x", "m", "m", "position", conserved}, &P::position},
        Field{FieldInfo{"volume", "w", "m^3", "m^2", "particle volume", conserved}, &P::volume},
        Field{FieldInfo{"mass", "m", "kg", "kg/m", "particle mass", conserved}, &P::mass},
        Field{FieldInfo{"momentum", "P", "kg m/s", "kg/s", "momentum, mass times velocity", conserved}, &P::momentum},
        Field{FieldInfo{"velocity", "v", "m/s", "m/s", "velocity", derived}, &P::velocity},
        Field{FieldInfo{"density", "rho", "kg/m^3", "kg/m^3", "density, mass over volume", derived}, &P::density},
        Field{FieldInfo{"pressure", "p", "Pa", "Pa", "pressure, positive in compression", derived}, &P::pressure},
        Field{FieldInfo{"sound_speed", "c", "m/s", "m/s", "speed of sound", derived}, &P::sound_speed},
        Field{FieldInfo{"density_gradient", "grad rho", "kg/m^4", "kg/m^4", "gradient of the density", derived},
              &P::density_gradient},
        Field{FieldInfo{"velocity_gradient", "grad v", "1/s", "1/s", "gradient of the velocity, row = component",
                        derived},
              &P::velocity_gradient},
        Field{FieldInfo{"renormaliser", "K", "-", "-", "factor of the pair areas", derived}, &P::renormaliser},
        Field{FieldInfo{"shift", "v_s", "m/s", "m/s", "velocity of the particle beside the fluid's", derived},
              &P::shift});
}

/// dx_i/dt = v + v_s [m/s].
template<int D> Vec<D> particle_velocity(const Particles<D>& particles, std::size_t i)
{
    return particles.velocity[i] + particles.shift[i];
}

/// Calls visit(info, column) for every field of the table, in its order.
template<int D, class Visitor> void for_each_field(Particles<D>& particles, Visitor&& visit)
{
    std::apply([&](const auto&... field) { (visit(field.info, particles.*(field.column)), ...); }, field_table<D>());
}

template<int D, class Visitor> void for_each_field(const Particles<D>& particles, Visitor&& visit)
{
    std::apply([&](const auto&... field) { (visit(field.info, particles.*(field.column)), ...); }, field_table<D>());
}

} // namespace sph

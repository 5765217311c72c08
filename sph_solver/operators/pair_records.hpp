// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/numerics/pack_columns.hpp"
#include "sph_solver/state/particles.hpp"

#include <array>
#include <vector>

namespace sph {

/// Place of A(a, b) in the upper triangle of a symmetric matrix, row by row.
template<int D> constexpr std::size_t upper_triangle(std::size_t a, std::size_t b)
{
    return a <= b ? a * D - a * (a + 1) / 2 + b : upper_triangle<D>(b, a);
}

/// The upper triangle of a symmetric matrix.
template<int D> using SymmetricPacks = std::array<Pack, D*(D + 1) / 2>;

/// Copies of the columns that the pair loops read, one cache line for each particle: a pair then costs one or two
/// line loads and a transposition in registers instead of a dozen scattered loads. Numbers without units where it
/// saves a product: q = rho / rho0. Indexed like `Particles`, halo copies included.
template<int D> class PairRecords {
public:
    static constexpr std::size_t state_size = 8;               // x, v, q, w; in 2D the last number of K
    static constexpr std::size_t slope_size = D == 2 ? 8 : 24; // grad q, grad v row by row, upper triangle of K

    /// Reads position, velocity, density and volume of some particles. \pre derived fields are up to date there.
    void load_states(const Particles<D>& particles, const Tait& eos, const std::vector<int>& which);
    /// Reads their gradients, and the factors of pair areas where these are renormalised. \pre they are up to date there.
    void load_slopes(const Particles<D>& particles, const FluidModel<D>& model, const std::vector<int>& which);

    [[nodiscard]] std::size_t size() const { return states_.size(); } ///< local particles

    const double* state(int i) const { return states_[static_cast<std::size_t>(i)].data.data(); }
    const double* slope(int i) const { return slopes_[static_cast<std::size_t>(i)].data.data(); }
    /// Shifting velocity. \pre particles are shifted
    const double* shift(int i) const { return shifts_[static_cast<std::size_t>(i)].data.data(); }
    /// The factor K of pair areas, out of columns of both records. \pre areas are renormalised
    static SymmetricPacks<D> area_of(const std::array<Pack, state_size>& state,
                                     const std::array<Pack, slope_size>& slope)
    {
        SymmetricPacks<D> area;
        for (std::size_t n = 0; n < area.size(); ++n) area[n] = n < slope_areas ? slope[area_begin + n] : state[7];
        return area;
    }

    static double ratio(const double* state) { return state[2 * D]; }
    static double volume(const double* state) { return state[2 * D + 1]; }

private:
    void load_state(const Particles<D>& particles, double inverse_rho0, std::size_t i);
    void load_slope(const Particles<D>& particles, double inverse_rho0, std::size_t i);
    void load_area(const Particles<D>& particles, std::size_t i);
    void load_shift(const Particles<D>& particles, std::size_t i);

    static constexpr std::size_t area_begin = D + D * D;
    static constexpr std::size_t slope_areas = D == 2 ? 2 : 6; // numbers of K that the slope record has room for

    struct alignas(64) State {
        std::array<double, state_size> data{};
    };
    struct alignas(64) Slope {
        std::array<double, slope_size> data{};
    };
    struct alignas(64) Shift {
        std::array<double, 8> data{};
    };

    std::vector<State> states_;
    std::vector<Slope> slopes_;
    std::vector<Shift> shifts_; ///< empty where particles are not shifted
};

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/numerics/pack_columns.hpp"
#include "sph_solver/state/particles.hpp"

#include <array>
#include <vector>

namespace sph {

/// Copies of the columns that the pair loops read, one cache line for each particle: a pair then costs one or two
/// line loads and a transposition in registers instead of a dozen scattered loads. Numbers without units where it
/// saves a product: q = rho / rho0. Indexed like `Particles`, halo copies included.
template<int D> class PairRecords {
public:
    static constexpr std::size_t state_size = 8;               // x, v, q, w
    static constexpr std::size_t slope_size = D == 2 ? 8 : 16; // grad q, grad v row by row, v_s
    static constexpr std::size_t area_size = D == 2 ? 8 : 16;  // K row by row

    /// Reads position, velocity, density and volume of some particles. \pre derived fields are up to date there.
    void load_states(const Particles<D>& particles, const Tait& eos, const std::vector<int>& which);
    /// Reads their gradients, and the factors of pair areas where these are renormalised. \pre they are up to date there.
    void load_slopes(const Particles<D>& particles, const FluidModel<D>& model, const std::vector<int>& which);

    [[nodiscard]] std::size_t size() const { return states_.size(); } ///< local particles

    const double* state(int i) const { return states_[static_cast<std::size_t>(i)].data.data(); }
    const double* slope(int i) const { return slopes_[static_cast<std::size_t>(i)].data.data(); }
    /// \pre areas are renormalised
    const double* area(int i) const { return areas_[static_cast<std::size_t>(i)].data.data(); }

    /// Place of the shifting velocity in a slope record.
    static constexpr std::size_t shift = D + D * D;

    static double ratio(const double* state) { return state[2 * D]; }
    static double volume(const double* state) { return state[2 * D + 1]; }

private:
    void load_state(const Particles<D>& particles, double inverse_rho0, std::size_t i);
    void load_slope(const Particles<D>& particles, double inverse_rho0, std::size_t i);
    void load_area(const Particles<D>& particles, std::size_t i);

    struct alignas(64) State {
        std::array<double, state_size> data{};
    };
    struct alignas(64) Slope {
        std::array<double, slope_size> data{};
    };
    struct alignas(64) Area {
        std::array<double, area_size> data{};
    };

    std::vector<State> states_;
    std::vector<Slope> slopes_;
    std::vector<Area> areas_; ///< empty where areas are raw
};

} // namespace sph

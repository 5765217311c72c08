// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/equation_of_state.hpp"
#include "sph_solver/numerics/pack.hpp"
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
    static constexpr std::size_t slope_size = D == 2 ? 8 : 12; // grad q, grad v row by row

    /// Reads position, velocity, density and volume. \pre derived fields are up to date on owned and halo particles.
    void load_states(const Particles<D>& particles, const Tait& eos);

    /// Reads the gradients. \pre they are up to date on owned and halo particles.
    void load_slopes(const Particles<D>& particles, const Tait& eos);

    const double* state(int i) const { return states_[static_cast<std::size_t>(i)].data.data(); }
    const double* slope(int i) const { return slopes_[static_cast<std::size_t>(i)].data.data(); }

    static double ratio(const double* state) { return state[2 * D]; }
    static double volume(const double* state) { return state[2 * D + 1]; }

private:
    struct alignas(64) State {
        std::array<double, state_size> data{};
    };
    struct alignas(32) Slope {
        std::array<double, slope_size> data{};
    };

    std::vector<State> states_;
    std::vector<Slope> slopes_;
};

/// Rows of four particles, loaded and turned into columns: result[c] holds component c of the particles index[0..3].
template<std::size_t Size, class Row>
[[gnu::always_inline]] inline std::array<Pack, Size> load_columns(Row row, const int* index)
{
    static_assert(Size % 4 == 0);
    const double* rows[4] = {row(index[0]), row(index[1]), row(index[2]), row(index[3])};
    std::array<Pack, Size> columns;
    for (std::size_t c = 0; c < Size; c += 4) {
        const auto part =
            transpose(load_pack(rows[0] + c), load_pack(rows[1] + c), load_pack(rows[2] + c), load_pack(rows[3] + c));
        for (std::size_t k = 0; k < 4; ++k) columns[c + k] = part[k];
    }
    return columns;
}

/// Calls visit(const int* four_indices) over a row of neighbours. The last pack is filled up with i itself: its
/// distance and its jumps are exactly zero, and so is all that it adds.
template<class Row, class Visit>
[[gnu::always_inline]] inline void for_each_pack(const Row& neighbours, int i, Visit visit)
{
    for (std::size_t n = 0; n < neighbours.size(); n += pack_size) {
        const int* indices = neighbours.data() + n;
        std::array<int, pack_size> last;
        if (n + pack_size > neighbours.size()) {
            last.fill(i);
            std::copy(neighbours.begin() + static_cast<std::ptrdiff_t>(n), neighbours.end(), last.begin());
            indices = last.data();
        }
        visit(indices);
    }
}

} // namespace sph

// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/numerics/vector.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace sph {

/// Cell number packed in one integer, the x index running fastest: three cells in a row along x have consecutive keys.
using CellKey = std::uint64_t;

/// Cubic cells that fill space. The origin is fixed at zero, so that a particle's cell depends on nothing but its
/// position: not on the rank, not on the other particles.
template<int D> class CellGrid {
public:
    using Cell = std::array<int, D>;

    explicit CellGrid(double cell_size) : size_(cell_size), per_size_(1.0 / cell_size) {}

    [[nodiscard]] double cell_size() const { return size_; }

    /// Cell that holds x. Throws Error(numerical_failure) when x is not a number or further out than 2^20 cells.
    [[nodiscard]] Cell cell_of(const Vec<D>& x) const
    {
        Cell cell{};
        for (int d = 0; d < D; ++d) {
            const double index = std::floor(x[d] * per_size_);
            base::require(std::abs(index) < half_range, base::ExitCode::numerical_failure, "a particle is at ", x[d],
                          " m along axis ", d, ", which is not a number or more than 2^20 cells of ", size_,
                          " m away: the computation has diverged");
            cell[static_cast<std::size_t>(d)] = static_cast<int>(index);
        }
        return cell;
    }

    [[nodiscard]] static CellKey key(const Cell& cell)
    {
        CellKey key = 0;
        for (std::size_t d = D; d-- > 0;) key = (key << bits) | static_cast<CellKey>(cell[d] + half_range);
        return key;
    }

    [[nodiscard]] static Cell cell(CellKey key)
    {
        Cell cell{};
        for (std::size_t d = 0; d < D; ++d, key >>= bits) {
            cell[d] = static_cast<int>(key & ((CellKey{1} << bits) - 1)) - half_range;
        }
        return cell;
    }

    [[nodiscard]] CellKey key_of(const Vec<D>& x) const { return key(cell_of(x)); }

private:
    static constexpr int bits = 21;
    static constexpr int half_range = 1 << 20;

    double size_;
    double per_size_;
};

} // namespace sph

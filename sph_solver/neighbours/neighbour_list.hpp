// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/vector.hpp"
#include "sph_solver/state/particles.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace sph {

/// Which pairs something keeps apart, such as a plate thinner than the kernel. Both answers must depend on the positions
/// alone, else ranks would disagree.
template<int D> struct PairFilter {
    std::function<bool(const Vec<D>& x_i)> concerns; ///< may any pair of this particle be kept apart?
    std::function<bool(const Vec<D>& x_i, const Vec<D>& x_j)> lets_pass; ///< may they interact? symmetric
};

/// Who may see whom, as compressed rows over the owned particles.
///
/// Row k belongs to the particle with local index particles.owned[k] and holds the local indices j != i with
/// |x_j - x_i| < reach at the time of the build, ascending: the canonical order of `Particles`. reach = 2 h + skin, so
/// that the list stays complete while no particle has moved further than skin / 2. Loops test r < 2 h themselves.
struct NeighbourList {
    std::vector<std::size_t> offsets = {0}; ///< owned + 1 entries
    std::vector<int> indices;               ///< local indices

    [[nodiscard]] std::size_t rows() const { return offsets.size() - 1; }

    /// Neighbours of the k-th owned particle.
    [[nodiscard]] std::span<const int> of(std::size_t k) const
    {
        return {indices.data() + offsets[k], offsets[k + 1] - offsets[k]};
    }
};

} // namespace sph

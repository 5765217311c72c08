// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/reproducible_sum.hpp"
#include "sph_solver/numerics/equation_of_state.hpp"
#include "sph_solver/state/particles.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace sph {

/// An opening: what lies on the side that the normal points to has left the domain.
template<int D> struct OutflowPlane {
    Vec<D> point;
    Vec<D> normal;
};

/// What has left since the start, on this rank; 2D: per metre of depth.
struct OutflowTotals {
    std::int64_t particles = 0;
    base::ReproducibleSum mass;                    ///< [kg]
    std::array<base::ReproducibleSum, 3> momentum; ///< [kg m/s]
    base::ReproducibleSum kinetic;                 ///< [J]
    base::ReproducibleSum potential;               ///< -m g.x [J]
    base::ReproducibleSum internal;                ///< [J]
};

/// Takes out the particles that have passed an opening or are trapped between walls, and counts what they take along.
template<int D> class Outflow {
public:
    Outflow() = default;
    Outflow(std::vector<OutflowPlane<D>> planes, const Tait& eos, const Vec<D>& gravity)
        : planes_(std::move(planes)), eos_(eos), gravity_(gravity)
    {}

    [[nodiscard]] bool empty() const { return planes_.empty(); }

    /// Removes my particles beyond a plane, and those that are marked; halo copies go too, so it belongs just before
    /// Domain::redistribute. \param trapped a mark for each of my particles, in their order; empty: none.
    void remove(Particles<D>& particles, const std::vector<std::uint8_t>& trapped = {});

    [[nodiscard]] const OutflowTotals& totals() const { return totals_; }   ///< all that is gone
    [[nodiscard]] const OutflowTotals& trapped() const { return trapped_; } ///< of it, what was trapped

private:
    [[nodiscard]] bool is_out(const Vec<D>& x) const;
    void count(OutflowTotals& totals, const Particles<D>& particles, std::size_t i) const;

    std::vector<OutflowPlane<D>> planes_;
    Tait eos_;
    Vec<D> gravity_ = Vec<D>::Zero();
    OutflowTotals totals_, trapped_;
};

} // namespace sph

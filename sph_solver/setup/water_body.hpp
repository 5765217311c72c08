// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/config/water_config.hpp"
#include "sph_solver/numerics/vector.hpp"

#include <cstdint>
#include <memory>

namespace sph {

/// A particle to be: where, and how much space is its own.
template<int D> struct WaterPoint {
    Vec<D> position; ///< [m]
    double volume;   ///< [m^D]
};

/// A body of water as a numbered set of points, so that any rank can make any part of it.
template<int D> class WaterBody {
public:
    virtual ~WaterBody() = default;
    [[nodiscard]] virtual std::int64_t count() const = 0;
    /// Point number k, 0 <= k < count().
    [[nodiscard]] virtual WaterPoint<D> point(std::int64_t k) const = 0;
    /// Height of its highest point along a unit vector [m], not of its highest particle.
    [[nodiscard]] virtual double top(const Vec<D>& up) const = 0;
};

/// A body of the given shape filled with particles `spacing` apart.
///   box   Cartesian lattice, particles centred in cells, the first row half a spacing from the faces; the spacing
///         is adjusted to fit whole cells in each direction
///   disc  rings about the centre, one spacing thick, for flows that a lattice would buckle (2D)
/// Throws Error(bad_input) when the shape is smaller than one spacing.
template<int D> std::unique_ptr<WaterBody<D>> make_water_body(const WaterConfig& water, double spacing);

} // namespace sph

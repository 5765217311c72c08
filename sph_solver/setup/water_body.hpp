// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/config/water_config.hpp"
#include "sph_solver/numerics/vector.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace sph {

/// A particle to be: where, and how much space is its own; what a file of particles may know besides.
template<int D> struct WaterPoint {
    Vec<D> position = Vec<D>::Zero();    ///< [m]
    double volume = 0.0;                 ///< [m^D]
    std::optional<Vec<D>> velocity = {}; ///< [m/s]
    std::optional<double> density = {};  ///< [kg/m^3]
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
    /// Whether x lies inside; a shape known only through its particles says so where it is sure.
    [[nodiscard]] virtual bool contains(const Vec<D>& x) const = 0;
};

/// A body whose points are listed one by one.
template<int D> class ListedWater : public WaterBody<D> {
public:
    explicit ListedWater(std::vector<WaterPoint<D>> points) : points_(std::move(points)) {}
    [[nodiscard]] std::int64_t count() const override { return static_cast<std::int64_t>(points_.size()); }
    [[nodiscard]] WaterPoint<D> point(std::int64_t k) const override { return points_[static_cast<std::size_t>(k)]; }

protected:
    std::vector<WaterPoint<D>> points_;
};

/// A body of the given shape filled with particles `spacing` apart.
///   box        Cartesian lattice, particles centred in cells, the first row half a spacing from the faces; the spacing
///              is adjusted to fit whole cells in each direction
///   disc       rings about the centre, one spacing apart, for flows that a lattice would buckle (2D)
///   polygon    the lattice of its bounding box; a cell that an edge cuts gives the part that is inside (2D)
///   stl        the same, inside a closed surface of triangles (3D)
///   film       columns of the lattice from the ground up to high: each is cut into whole layers about one spacing thick;
///              columns of less than half a spacing stay dry
///   particles  as listed in an HDF5 file
/// The volumes of the particles add up to the volume of the shape. Throws Error(bad_input) when the shape is smaller than
/// one spacing, not closed, or crosses itself.
template<int D> std::unique_ptr<WaterBody<D>> make_water_body(const WaterConfig& water, double spacing);

// The shapes that have a file of their own.
std::unique_ptr<WaterBody<2>> make_polygon(const WaterConfig& water, double spacing);
std::unique_ptr<WaterBody<3>> make_stl_water(const WaterConfig& water, double spacing);
template<int D> std::unique_ptr<WaterBody<D>> make_film(const WaterConfig& water, double spacing);
template<int D> std::unique_ptr<WaterBody<D>> read_particles(const WaterConfig& water);

} // namespace sph

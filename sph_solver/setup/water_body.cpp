// SPDX-License-Identifier: MIT
#include "sph_solver/setup/water_body.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace sph {
namespace {

template<int D> Vec<D> to_vec(const std::vector<double>& numbers) { return Eigen::Map<const Vec<D>>(numbers.data()); }

template<int D> class Box final : public WaterBody<D> {
public:
    Box(const WaterConfig& water, double spacing) : low_(to_vec<D>(water.low)), high_(to_vec<D>(water.high))
    {
        for (std::size_t d = 0; d < D; ++d) {
            const double length = water.high[d] - water.low[d];
            cells_[d] = std::llround(length / spacing);
            base::require_input(cells_[d] > 0, "a box of water is ", length, " m long along axis ", d,
                                ", less than half a particle spacing (", spacing, " m)");
            step_[static_cast<int>(d)] = length / static_cast<double>(cells_[d]);
        }
    }

    std::int64_t count() const override
    {
        std::int64_t product = 1;
        for (const std::int64_t cells : cells_) product *= cells;
        return product;
    }

    WaterPoint<D> point(std::int64_t k) const override
    {
        Vec<D> x;
        for (std::size_t d = 0; d < D; ++d, k /= cells_[d - 1]) {
            const auto axis = static_cast<int>(d);
            x[axis] = low_[axis] + (static_cast<double>(k % cells_[d]) + 0.5) * step_[axis];
        }
        return {x, step_.prod()};
    }

    bool contains(const Vec<D>& x) const override
    {
        return (x.array() > low_.array()).all() && (x.array() < high_.array()).all();
    }

    double top(const Vec<D>& up) const override
    {
        return (low_.array() * up.array()).max(high_.array() * up.array()).sum();
    }

private:
    Vec<D> low_, high_, step_;
    std::array<std::int64_t, D> cells_{};
};

/// A particle in the centre and 6 k on ring k, every second ring turned by half a gap: nearly the hexagonal lattice, bent.
/// The order matters: with rings turned at random the pressure's quadrature errors shake the particles, and the
/// stretching patch loses energy at a rate that no longer falls with dx (docs/decisions/0007_rings_of_six.md).
class Disc final : public WaterBody<2> {
public:
    Disc(const WaterConfig& water, double spacing) : centre_(to_vec<2>(water.centre)), radius_(water.radius)
    {
        base::require_input(radius_ >= 0.5 * spacing, "a disc of water has a radius of ", radius_,
                            " m, less than half a particle spacing (", spacing, " m)");
        rings_ = static_cast<std::int64_t>(radius_ / spacing + 1e-9);
        thickness_ = radius_ / (static_cast<double>(rings_) + 0.5);
    }

    std::int64_t count() const override { return 1 + 3 * rings_ * (rings_ + 1); }

    WaterPoint<2> point(std::int64_t k) const override
    {
        const double square = thickness_ * thickness_;
        if (k == 0) return {centre_, 0.25 * std::numbers::pi * square};
        std::int64_t ring = 1;
        while (1 + 3 * ring * (ring + 1) <= k) ++ring;
        const auto place = static_cast<double>(k - 1 - 3 * ring * (ring - 1));
        const double angle =
            std::numbers::pi / (3.0 * static_cast<double>(ring)) * (place + 0.5 * static_cast<double>(ring % 2));
        const double r = static_cast<double>(ring) * thickness_;
        return {centre_ + r * Vec<2>(std::cos(angle), std::sin(angle)), std::numbers::pi / 3.0 * square};
    }

    double top(const Vec<2>& up) const override { return centre_.dot(up) + radius_; }
    bool contains(const Vec<2>& x) const override { return (x - centre_).norm() < radius_; }

private:
    Vec<2> centre_;
    double radius_;
    double thickness_ = 0.0;
    std::int64_t rings_ = 0;
};

} // namespace

template<int D> std::unique_ptr<WaterBody<D>> make_water_body(const WaterConfig& water, double spacing)
{
    if constexpr (D == 2) {
        if (water.shape == "disc") return std::make_unique<Disc>(water, spacing);
        if (water.shape == "polygon") return make_polygon(water, spacing);
    } else {
        if (water.shape == "stl") return make_stl_water(water, spacing);
    }
    if (water.shape == "film") return make_film<D>(water, spacing);
    if (water.shape == "particles") return read_particles<D>(water);
    return std::make_unique<Box<D>>(water, spacing);
}

template std::unique_ptr<WaterBody<2>> make_water_body(const WaterConfig&, double);
template std::unique_ptr<WaterBody<3>> make_water_body(const WaterConfig&, double);

} // namespace sph

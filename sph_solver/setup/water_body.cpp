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

/// Ring k lies between k and k + 1 times the thickness; its particles share its area evenly.
class Disc final : public WaterBody<2> {
public:
    Disc(const WaterConfig& water, double spacing) : centre_(to_vec<2>(water.centre)), radius_(water.radius)
    {
        const auto rings = std::llround(radius_ / spacing);
        base::require_input(rings > 0, "a disc of water has a radius of ", radius_,
                            " m, less than half a particle spacing (", spacing, " m)");
        thickness_ = radius_ / static_cast<double>(rings);
        for (std::int64_t ring = 0; ring < rings; ++ring) {
            const double middle = (static_cast<double>(ring) + 0.5) * thickness_;
            const auto particles =
                std::max<std::int64_t>(3, std::llround(2.0 * std::numbers::pi * middle / thickness_));
            begins_.push_back(begins_.back() + particles);
        }
    }

    std::int64_t count() const override { return begins_.back(); }

    WaterPoint<2> point(std::int64_t k) const override
    {
        const auto next = std::upper_bound(begins_.begin(), begins_.end(), k);
        const auto ring = static_cast<double>(next - begins_.begin() - 1);
        const auto particles = static_cast<double>(*next - *(next - 1));
        const double golden = 2.399963229728653; // radians; turns each ring against the last, so that no spokes form
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k - *(next - 1)) / particles + golden * ring;
        const double area = std::numbers::pi * (2.0 * ring + 1.0) * thickness_ * thickness_;
        return {centre_ + (ring + 0.5) * thickness_ * Vec<2>(std::cos(angle), std::sin(angle)), area / particles};
    }

    double top(const Vec<2>& up) const override { return centre_.dot(up) + radius_; }
    bool contains(const Vec<2>& x) const override { return (x - centre_).norm() < radius_; }

private:
    Vec<2> centre_;
    double radius_;
    double thickness_ = 0.0;
    std::vector<std::int64_t> begins_ = {0};
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
    if (water.shape == "particles") return read_particles<D>(water);
    return std::make_unique<Box<D>>(water, spacing);
}

template std::unique_ptr<WaterBody<2>> make_water_body(const WaterConfig&, double);
template std::unique_ptr<WaterBody<3>> make_water_body(const WaterConfig&, double);

} // namespace sph

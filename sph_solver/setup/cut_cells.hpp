// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/base/geometry.hpp"
#include "sph_solver/setup/water_body.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace sph {

/// The lattice of a bounding box, of which a shape takes each cell whole, in part, or not: what it takes becomes particles.
template<int D> class CutCells {
public:
    using Cell = std::array<std::int64_t, D>;

    /// Whole cells of about `spacing` in each direction. Throws Error(bad_input), beginning with `what`, when the box is
    /// thinner than half a spacing.
    CutCells(const base::Box<D>& bounds, double spacing, const char* what);

    [[nodiscard]] std::int64_t cells(int axis) const { return cells_[static_cast<std::size_t>(axis)]; }
    [[nodiscard]] const Vec<D>& step() const { return step_; } ///< sides of a cell [m]
    [[nodiscard]] const Vec<D>& low() const { return bounds_.low; }
    [[nodiscard]] const base::Box<D>& bounds() const { return bounds_; }

    /// Adds to what the shape takes of a cell: a volume [m^D] and its moment, the integral of x over it [m^(D+1)].
    void add(const Cell& cell, double volume, const Vec<D>& moment);

    /// Volume taken of all cells [m^D].
    [[nodiscard]] double volume() const;

    /// Whether x lies in a cell that the shape takes whole.
    [[nodiscard]] bool full_at(const Vec<D>& x) const;

    /// A particle in the centroid of what is taken of each cell. A part smaller than half a cell joins the largest part
    /// that it shares a face with, the smallest part first; volume and centroid of the whole stay exact.
    [[nodiscard]] std::vector<WaterPoint<D>> particles() const;

private:
    struct Part {
        double volume = 0.0;
        Vec<D> moment = Vec<D>::Zero();
    };

    [[nodiscard]] std::int64_t index(const Cell& cell) const;
    [[nodiscard]] std::int64_t largest_neighbour(const std::vector<Part>& parts, std::int64_t cell) const;

    base::Box<D> bounds_;
    Vec<D> step_;
    Cell cells_{};
    std::vector<Part> parts_;
};

} // namespace sph

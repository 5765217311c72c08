// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/setup/cut_cells.hpp"

#include <algorithm>

namespace sph {
namespace {

using Ring = std::vector<Vec<2>>;

double cross(const Vec<2>& a, const Vec<2>& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Area of a ring and its moment, the integral of x over it: sums over the edges of a x b / 2 and a x b (a + b) / 6.
struct RingArea {
    double area = 0.0;              ///< [m^2], positive for a counterclockwise ring
    Vec<2> moment = Vec<2>::Zero(); ///< [m^3]

    explicit RingArea(const Ring& ring)
    {
        if (ring.empty()) return;
        const Vec<2> origin = ring.front();
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec<2> a = ring[k] - origin, b = ring[(k + 1) % ring.size()] - origin;
            area += 0.5 * cross(a, b);
            moment += cross(a, b) / 6.0 * (a + b);
        }
        moment += area * origin;
    }
};

/// What lies of a ring on one side of the line x[axis] = bound (Sutherland and Hodgman, 1974). Where the ring falls into
/// several pieces, edges that run to and fro along the line join them; they add nothing to area and moment.
Ring cut(const Ring& ring, int axis, double bound, double side)
{
    Ring kept;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec<2>&a = ring[k], &b = ring[(k + 1) % ring.size()];
        const double from = side * (a[axis] - bound), to = side * (b[axis] - bound);
        if (from >= 0.0) kept.push_back(a);
        if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0)) {
            Vec<2> meeting = a + from / (from - to) * (b - a);
            meeting[axis] = bound;
            kept.push_back(meeting);
        }
    }
    return kept;
}

Ring strip(const Ring& ring, int axis, double low, double high)
{
    return cut(cut(ring, axis, low, 1.0), axis, high, -1.0);
}

void require_simple(const Ring& ring)
{
    const auto edge = [&](std::size_t k) { return base::Simplex<2>{ring[k], ring[(k + 1) % ring.size()]}; };
    for (std::size_t a = 0; a < ring.size(); ++a)
        base::require_input(edge(a)[0] != edge(a)[1], "a polygon of water: points ", a + 1, " and ",
                            (a + 1) % ring.size() + 1, " are the same; remove one");
    for (std::size_t a = 0; a < ring.size(); ++a) {
        for (std::size_t b = a + 2; b < ring.size(); ++b) {
            if (a == 0 && b + 1 == ring.size()) continue; // these two share the first point
            base::require_input(base::simplex_distance<2>(edge(a), edge(b)) > 0.0,
                                "a polygon of water crosses or touches ", "itself: the edges after its points ", a + 1,
                                " and ", b + 1);
        }
    }
}

class Polygon final : public ListedWater<2> {
public:
    Polygon(std::vector<WaterPoint<2>> points, Ring ring) : ListedWater<2>(std::move(points)), ring_(std::move(ring)) {}

    double top(const Vec<2>& up) const override
    {
        double highest = ring_.front().dot(up);
        for (const auto& corner : ring_) highest = std::max(highest, corner.dot(up));
        return highest;
    }

    /// An odd number of edges lies to the right of a point inside.
    bool contains(const Vec<2>& x) const override
    {
        bool inside = false;
        for (std::size_t k = 0; k < ring_.size(); ++k) {
            const Vec<2>&a = ring_[k], &b = ring_[(k + 1) % ring_.size()];
            if ((a.y() > x.y()) == (b.y() > x.y())) continue;
            if (x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
        }
        return inside;
    }

private:
    Ring ring_;
};

/// Rows of the lattice are cut out of the ring first, then each row's cells.
void take_cells(CutCells<2>& cells, const Ring& ring)
{
    const Vec<2> low = cells.low(), step = cells.step();
    const auto line = [&](int axis, std::int64_t k) {
        return k == cells.cells(axis) ? cells.bounds().high[axis] : low[axis] + static_cast<double>(k) * step[axis];
    };
    for (std::int64_t row = 0; row < cells.cells(1); ++row) {
        const Ring part = strip(ring, 1, line(1, row), line(1, row + 1));
        for (std::int64_t column = 0; column < cells.cells(0); ++column) {
            const RingArea inside(strip(part, 0, line(0, column), line(0, column + 1)));
            if (inside.area > 1e-12 * step.prod()) cells.add({column, row}, inside.area, inside.moment);
        }
    }
}

} // namespace

std::unique_ptr<WaterBody<2>> make_polygon(const WaterConfig& water, double spacing)
{
    Ring ring;
    base::Box<2> bounds;
    for (const auto& point : water.points) {
        ring.emplace_back(point[0], point[1]);
        bounds.include(ring.back());
    }
    require_simple(ring);
    if (RingArea(ring).area < 0.0) std::reverse(ring.begin(), ring.end());
    CutCells<2> cells(bounds, spacing, "a polygon of water");
    take_cells(cells, ring);
    return std::make_unique<Polygon>(cells.particles(), std::move(ring));
}

} // namespace sph

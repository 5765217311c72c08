// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// \file
/// Simplices that bound a body: segments in 2D, triangles in 3D, as arrays of D corners. The body lies on the left of a
/// segment; the corners of a triangle run counterclockwise seen from outside. Lengths in metres.
namespace base {

template<int D> using Point = Eigen::Matrix<double, D, 1>;

/// Corners of a segment (D = 2) or triangle (D = 3).
template<int D> using Simplex = std::array<Point<D>, D>;

/// The point of a simplex that is nearest to a given one: sum_c weight[c] corner[c]; the weights add up to 1.
template<int D> struct ClosestPoint {
    Point<D> point = Point<D>::Zero(); ///< [m]
    std::array<double, D> weight{};    ///< linear shape functions of the corners at `point`, each in [0, 1]
    double squared_distance = std::numeric_limits<double>::max(); ///< [m^2]
};

/// Weighted corners, with the distance to x.
template<int D>
ClosestPoint<D> point_at(const Simplex<D>& corners, const std::array<double, D>& weight, const Point<D>& x)
{
    ClosestPoint<D> closest;
    closest.weight = weight;
    for (int c = 0; c < D; ++c) closest.point += weight[c] * corners[c];
    closest.squared_distance = (x - closest.point).squaredNorm();
    return closest;
}

/// Fraction s in [0, 1] at which the segment a + s (b - a) comes nearest to x; 0 for a segment without length.
template<int D> double nearest_fraction(const Point<D>& a, const Point<D>& b, const Point<D>& x)
{
    const Point<D> along = b - a;
    const double square = along.squaredNorm();
    return square > 0 ? std::clamp((x - a).dot(along) / square, 0.0, 1.0) : 0.0;
}

/// Nearest point of a segment in the plane.
inline ClosestPoint<2> closest_point(const Simplex<2>& corners, const Point<2>& x)
{
    const double s = nearest_fraction<2>(corners[0], corners[1], x);
    return point_at<2>(corners, {1.0 - s, s}, x);
}

/// Nearest point of a triangle in space: the foot of the perpendicular where it lies inside, else the nearest of the
/// three edges.
inline ClosestPoint<3> closest_point(const Simplex<3>& corners, const Point<3>& x)
{
    const Point<3> u = corners[1] - corners[0], v = corners[2] - corners[0], d = x - corners[0];
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), du = d.dot(u), dv = d.dot(v);
    const double determinant = uu * vv - uv * uv;
    if (determinant > 0) {
        const double s = (vv * du - uv * dv) / determinant, t = (uu * dv - uv * du) / determinant;
        if (s >= 0 && t >= 0 && s + t <= 1) return point_at<3>(corners, {1 - s - t, s, t}, x);
    }
    ClosestPoint<3> best;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3;
        const double s = nearest_fraction<3>(corners[a], corners[b], x);
        std::array<double, 3> weight{};
        weight[a] = 1 - s;
        weight[b] = s;
        const auto candidate = point_at<3>(corners, weight, x);
        if (candidate.squared_distance < best.squared_distance) best = candidate;
    }
    return best;
}

/// Normal times measure, pointing out of the body: (t_y, -t_x) of a segment [m], half the cross product of a triangle
/// [m^2].
inline Point<2> area_vector(const Simplex<2>& corners)
{
    const Point<2> t = corners[1] - corners[0];
    return {t.y(), -t.x()};
}
inline Point<3> area_vector(const Simplex<3>& corners)
{
    const Point<3> u = corners[1] - corners[0], v = corners[2] - corners[0];
    return 0.5 * Point<3>(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x());
}

/// Where the straight way from p to q meets the simplex: fraction in [0, 1] of the way, or -1 if it does not.
template<int D> double crossing_fraction(const Simplex<D>& corners, const Point<D>& p, const Point<D>& q)
{
    const Point<D> normal = area_vector(corners);
    const double from = (p - corners[0]).dot(normal), to = (q - corners[0]).dot(normal);
    if (from == to || (from > 0) == (to > 0)) return -1;
    const double fraction = from / (from - to);
    const Point<D> hit = p + fraction * (q - p);
    const auto closest = closest_point(corners, hit);
    return closest.squared_distance <= 1e-18 * normal.squaredNorm() + 1e-24 * hit.squaredNorm() ? fraction : -1;
}

/// Distance between two segments in space [m].
inline double segment_distance(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& d)
{
    const Point<3> u = b - a, v = d - c, w = a - c;
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
    const double determinant = uu * vv - uv * uv;
    double best = std::numeric_limits<double>::max();
    if (determinant > 1e-14 * uu * vv) {
        const double s = (uv * vw - vv * uw) / determinant, t = (uu * vw - uv * uw) / determinant;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) best = (w + s * u - t * v).norm();
    }
    const auto to_point = [&](const Point<3>& x, const Point<3>& p, const Point<3>& q) {
        best = std::min(best, (p + nearest_fraction<3>(p, q, x) * (q - p) - x).norm());
    };
    to_point(a, c, d);
    to_point(b, c, d);
    to_point(c, a, b);
    to_point(d, a, b);
    return best;
}

/// Distance between two simplices [m]; 0 where they cross.
template<int D> double simplex_distance(const Simplex<D>& a, const Simplex<D>& b)
{
    double square = std::numeric_limits<double>::max();
    for (int c = 0; c < D; ++c) {
        square = std::min(square, closest_point(a, b[c]).squared_distance);
        square = std::min(square, closest_point(b, a[c]).squared_distance);
    }
    double distance = std::sqrt(square);
    for (int c = 0; c < D; ++c) {
        const int next = (c + 1) % D;
        if (D == 2 && c == 1) break;
        if (crossing_fraction<D>(a, b[c], b[next]) >= 0 || crossing_fraction<D>(b, a[c], a[next]) >= 0) return 0.0;
        if constexpr (D == 3)
            for (int e = 0; e < D; ++e)
                distance = std::min(distance, segment_distance(a[c], a[next], b[e], b[(e + 1) % D]));
    }
    return distance;
}

/// Axis-parallel box, empty when made.
template<int D> struct Box {
    Point<D> low = Point<D>::Constant(std::numeric_limits<double>::max());
    Point<D> high = Point<D>::Constant(std::numeric_limits<double>::lowest());

    void include(const Point<D>& x)
    {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    bool empty() const { return (low.array() > high.array()).any(); }
    /// The box with `margin` [m] added on every side.
    Box widened(double margin) const { return {low - Point<D>::Constant(margin), high + Point<D>::Constant(margin)}; }
    bool touches(const Box& other) const
    {
        return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
    }
};

template<int D> Box<D> box_around(const Simplex<D>& corners)
{
    Box<D> box;
    for (const auto& corner : corners) box.include(corner);
    return box;
}

} // namespace base

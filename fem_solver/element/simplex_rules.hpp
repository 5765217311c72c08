// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/element/gauss.hpp"

namespace fem {

/// Rules on the reference triangle and tetrahedron, all weights positive
/// (G. R. Cowper, Int. J. Numer. Meth. Engng 7 (1973) 405; P. Keast, Comput. Methods Appl. Mech. Engrg 55 (1986) 339).
///
/// \param degree of the polynomials integrated exactly: 1, 2 or 4 (the tetrahedron's last rule reaches 5).
inline std::vector<GaussPoint<2>> triangle_points(int degree)
{
    std::vector<GaussPoint<2>> points;
    const auto add_three = [&](double a, double weight) { // (a, a) and its turns about the centre
        for (const Eigen::Vector2d& xi :
             {Eigen::Vector2d(a, a), Eigen::Vector2d(1 - 2 * a, a), Eigen::Vector2d(a, 1 - 2 * a)})
            points.push_back({xi, 0.5 * weight});
    };
    if (degree == 1) return {{Eigen::Vector2d::Constant(1.0 / 3), 0.5}};
    if (degree == 2) {
        add_three(1.0 / 6, 1.0 / 3);
        return points;
    }
    const double r = std::sqrt(10.0), s = std::sqrt(38 - 44 * std::sqrt(0.4)), v = std::sqrt(213125 - 53320 * r);
    add_three((8 - r + s) / 18, (620 + v) / 3720);
    add_three((8 - r - s) / 18, (620 - v) / 3720);
    return points;
}

inline std::vector<GaussPoint<3>> tetrahedron_points(int degree)
{
    std::vector<GaussPoint<3>> points;
    const auto add_four = [&](double a, double weight) { // three coordinates a, the fourth the rest
        for (int k = 0; k < 4; ++k) {
            Eigen::Vector3d xi = Eigen::Vector3d::Constant(a);
            if (k < 3) xi[k] = 1 - 3 * a;
            points.push_back({xi, weight / 6});
        }
    };
    if (degree == 1) return {{Eigen::Vector3d::Constant(0.25), 1.0 / 6}};
    if (degree == 2) {
        add_four((5 - std::sqrt(5.0)) / 20, 0.25);
        return points;
    }
    const double r = std::sqrt(15.0), b = (10 - 2 * r) / 40;
    points.push_back({Eigen::Vector3d::Constant(0.25), 16.0 / 135 / 6});
    add_four((7 - r) / 34, (2665 + 14 * r) / 37800);
    add_four((7 + r) / 34, (2665 - 14 * r) / 37800);
    for (int k = 0; k < 3; ++k)
        for (const double side : {b, 0.5 - b}) { // two coordinates b, two 1/2 - b
            Eigen::Vector3d xi = Eigen::Vector3d::Constant(side);
            xi[k] = 0.5 - side;
            points.push_back({xi, 10.0 / 189 / 6});
        }
    return points;
}

/// The points of a shape: tensor Gauss with n points a direction, on triangles and tetrahedra a rule of degree n.
template<class Shape> std::vector<GaussPoint<Shape::dimension>> integration_points(int n)
{
    if constexpr (!requires { Shape::simplex; })
        return gauss_points<Shape::dimension>(n);
    else if constexpr (Shape::dimension == 2)
        return triangle_points(n);
    else
        return tetrahedron_points(n);
}

/// The points for a load on a face: p N_a n is integrated exactly for a constant p, with p linear on flat faces too.
template<class FaceShape> std::vector<GaussPoint<FaceShape::dimension>> face_points()
{
    if constexpr (requires { FaceShape::simplex; })
        return integration_points<FaceShape>(FaceShape::mass_gauss);
    else
        return integration_points<FaceShape>(FaceShape::gauss);
}

} // namespace fem

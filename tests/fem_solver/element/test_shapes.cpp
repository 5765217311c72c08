// SPDX-License-Identifier: MIT
#include "fem_solver/element/element_type.hpp"
#include "fem_solver/element/face_normal.hpp"
#include "fem_solver/element/simplex_rules.hpp"

#include <gtest/gtest.h>

namespace {

using namespace fem;

template<class Shape> class Shapes : public testing::Test {};
using AllShapes = testing::Types<Line2, Line3, Tri3, Tri6, Quad4, Quad8, Quad9, Tet4, Tet10, Hexa8, Hexa20, Hexa27>;
TYPED_TEST_SUITE(Shapes, AllShapes);

template<class Shape> Eigen::Matrix<double, Shape::dimension, 1> corner(int a)
{
    Eigen::Matrix<double, Shape::dimension, 1> xi;
    for (int k = 0; k < Shape::dimension; ++k) xi[k] = Shape::corners[a][k];
    return xi;
}

template<class Shape> Eigen::Matrix<double, Shape::dimension, 1> inner_point()
{
    Eigen::Matrix<double, Shape::dimension, 1> xi;
    for (int k = 0; k < Shape::dimension; ++k) xi[k] = 0.31 - 0.11 * k;
    return xi;
}

/// Length, area or volume of the reference element.
template<class Shape> double reference_measure()
{
    if (is_simplex<Shape>) return Shape::dimension == 2 ? 0.5 : 1.0 / 6;
    return std::pow(2.0, Shape::dimension);
}

TYPED_TEST(Shapes, AreOneAtTheirNodeAndZeroAtTheOthers)
{
    for (int a = 0; a < TypeParam::nodes; ++a)
        for (int b = 0; b < TypeParam::nodes; ++b)
            EXPECT_NEAR(TypeParam::values(corner<TypeParam>(a))[b], a == b ? 1 : 0, 1e-15) << a << " " << b;
}

TYPED_TEST(Shapes, SumToOne)
{
    EXPECT_NEAR(TypeParam::values(inner_point<TypeParam>()).sum(), 1, 1e-15);
    for (int k = 0; k < TypeParam::dimension; ++k)
        EXPECT_NEAR(TypeParam::gradients(inner_point<TypeParam>()).row(k).sum(), 0, 1e-15);
}

TYPED_TEST(Shapes, GradientsAreDifferenceQuotients)
{
    const auto xi = inner_point<TypeParam>();
    const double h = 1e-5;
    for (int k = 0; k < TypeParam::dimension; ++k) {
        auto up = xi, down = xi;
        up[k] += h;
        down[k] -= h;
        const auto quotient = ((TypeParam::values(up) - TypeParam::values(down)) / (2 * h)).eval();
        EXPECT_LT((quotient - TypeParam::gradients(xi).row(k)).cwiseAbs().maxCoeff(), 1e-9);
    }
}

/// The monomial x^a y^b (z^c) over the reference simplex: a! b! c! / (a + b + c + D)!.
TEST(SimplexRules, IntegratePolynomialsExactly)
{
    const auto exact = [](int a, int b, int c, int d) {
        return std::tgamma(a + 1) * std::tgamma(b + 1) * std::tgamma(c + 1) / std::tgamma(a + b + c + d + 1);
    };
    for (const int degree : {1, 2, 4})
        for (int a = 0; a <= degree; ++a)
            for (int b = 0; a + b <= degree; ++b) {
                double area = 0;
                for (const auto& p : triangle_points(degree))
                    area += p.weight * std::pow(p.xi[0], a) * std::pow(p.xi[1], b);
                EXPECT_NEAR(area, exact(a, b, 0, 2), 1e-15) << degree << " " << a << b;
                for (int c = 0; a + b + c <= (degree == 4 ? 5 : degree); ++c) {
                    double volume = 0;
                    for (const auto& p : tetrahedron_points(degree))
                        volume += p.weight * std::pow(p.xi[0], a) * std::pow(p.xi[1], b) * std::pow(p.xi[2], c);
                    EXPECT_NEAR(volume, exact(a, b, c, 3), 1e-15) << degree << " " << a << b << c;
                }
            }
}

TEST(Gauss, IntegratesPolynomialsExactly)
{
    for (int n = 1; n <= 3; ++n)
        for (int degree = 0; degree <= 2 * n - 1; ++degree) {
            double sum = 0;
            for (const auto& p : gauss_points<1>(n)) sum += p.weight * std::pow(p.xi[0], degree);
            EXPECT_NEAR(sum, degree % 2 ? 0 : 2.0 / (degree + 1), 1e-14) << n << " points, degree " << degree;
        }
}

template<class Shape> class Bodies : public testing::Test {};
using BodyShapes = testing::Types<Tri3, Tri6, Quad4, Quad8, Quad9, Tet4, Tet10, Hexa8, Hexa20, Hexa27>;
TYPED_TEST_SUITE(Bodies, BodyShapes);

/// The faces of the reference element, integrated: n points outward and the whole of the surface closes.
TYPED_TEST(Bodies, FacesPointOutwardAndClose)
{
    constexpr int D = TypeParam::dimension;
    using Face = typename TypeParam::Face;
    Eigen::Matrix<double, D, 1> sum = Eigen::Matrix<double, D, 1>::Zero();
    double volume = 0;
    for (const auto& face : TypeParam::faces) {
        Eigen::Matrix<double, D, Face::nodes> x;
        for (int a = 0; a < Face::nodes; ++a) x.col(a) = corner<TypeParam>(face[a]);
        for (const auto& p : face_points<Face>()) {
            const Eigen::Matrix<double, D, D - 1> tangents = x.lazyProduct(Face::gradients(p.xi).transpose());
            const Eigen::Matrix<double, D, 1> n = p.weight * face_normal(tangents);
            sum += n;
            volume += n.dot(x.lazyProduct(Face::values(p.xi).transpose())) / D; // Gauss's theorem for the field x
        }
    }
    EXPECT_LT(sum.norm(), 1e-14);
    EXPECT_NEAR(volume, reference_measure<TypeParam>(), 1e-13);
}

TYPED_TEST(Bodies, LinearPartsOfAFaceCoverIt)
{
    using Face = typename TypeParam::Face;
    double measure = 0;
    for (const auto& part : Face::linear_parts) {
        const auto a = corner<Face>(part[0]), b = corner<Face>(part[1]);
        if constexpr (Face::dimension == 1) {
            measure += b[0] - a[0];
        } else {
            for (std::size_t i = 1; i + 1 < part.size(); ++i) { // fan of triangles, counterclockwise
                const Eigen::Vector2d p = corner<Face>(part[i]) - a, q = corner<Face>(part[i + 1]) - a;
                measure += 0.5 * (p[0] * q[1] - p[1] * q[0]);
            }
        }
    }
    EXPECT_NEAR(measure, reference_measure<Face>(), 1e-14);
}

} // namespace

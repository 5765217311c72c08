// SPDX-License-Identifier: MIT
// Grounds of triangles: distance, side and derivatives, against brute force and exact shapes.
#include "coupler_lib/base/ground.hpp"
#include "coupler_lib/base/hdf5_file.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

namespace {

using namespace base;
using Eigen::Vector3d;

std::string scratch(const std::string& name) { return (std::filesystem::temp_directory_path() / name).string(); }

std::string refusal_of(const std::function<void()>& action)
{
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "";
}

/// gap_slope and normal_slope against difference quotients.
void expect_exact_slopes(const Ground& ground, const Vector3d& x)
{
    const double h = 1e-6;
    const GroundPoint here = ground.at(x);
    EXPECT_NEAR(here.normal.norm(), 1, 1e-14);
    for (int k = 0; k < 3; ++k) {
        const Vector3d step = h * Vector3d::Unit(k);
        const GroundPoint up = ground.at(x + step), down = ground.at(x - step);
        EXPECT_NEAR(here.gap_slope[k], (up.gap - down.gap) / (2 * h), 1e-8);
        EXPECT_LT((here.normal_slope.col(k) - (up.normal - down.normal) / (2 * h)).norm(), 1e-6);
    }
}

/// The unit cube, normals out of it.
TriangleMesh cube()
{
    std::vector<Simplex<3>> triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {0.0, 1.0}) {
            const auto corner = [&](double u, double v) {
                Vector3d x;
                x[axis] = side;
                x[(axis + 1) % 3] = side > 0 ? u : v;
                x[(axis + 2) % 3] = side > 0 ? v : u;
                return x;
            };
            triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
            triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
        }
    return join(triangles);
}

/// A sphere of radius 1 with n x 2n patches.
TriangleMesh sphere(int n)
{
    const auto at = [&](int i, int j) {
        const double theta = M_PI * i / n, phi = M_PI * (j % (2 * n)) / n;
        const double ring = i == 0 || i == n ? 0.0 : std::sin(theta);
        return Vector3d(ring * std::cos(phi), ring * std::sin(phi), std::cos(theta));
    };
    std::vector<Simplex<3>> triangles;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return join(triangles);
}

TEST(SurfaceGround, OfACubeIsItsSignedDistance)
{
    const auto ground = make_surface_ground(cube(), "cube");
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 2);
    for (int i = 0; i < 2000; ++i) {
        const Vector3d x(any(random), any(random), any(random));
        const Vector3d outside = (x - x.cwiseMax(0).cwiseMin(1));
        const double inside = std::min(x.minCoeff(), (Vector3d::Ones() - x).minCoeff());
        EXPECT_NEAR(ground->at(x).gap, outside.norm() > 0 ? outside.norm() : -inside, 1e-12) << x.transpose();
    }
}

TEST(SurfaceGround, HasExactDerivativesOverFacesEdgesAndCorners)
{
    const auto ground = make_surface_ground(cube(), "cube");
    for (const Vector3d& x : {Vector3d(0.3, 0.4, 1.2), Vector3d(0.3, 0.45, 0.9), Vector3d(1.2, 0.4, 1.3),
                              Vector3d(1.2, 1.4, 1.3), Vector3d(0.5, 0.5, 1.1)})
        expect_exact_slopes(*ground, x);
    EXPECT_EQ(ground->at({0.5, 0.5, 1.1}).normal_slope.norm(), 0); // over the seam between two triangles of a face
}

/// The search by boxes finds what trying all triangles finds.
TEST(SurfaceGround, FindsTheNearestOfManyTriangles)
{
    const TriangleMesh mesh = sphere(20);
    const auto ground = make_surface_ground(mesh, "sphere");
    std::mt19937 random(3);
    std::normal_distribution<double> any(0, 1);
    for (int i = 0; i < 500; ++i) {
        const Vector3d x(any(random), any(random), any(random));
        double nearest = std::numeric_limits<double>::max();
        for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
            nearest = std::min(nearest, closest_point(mesh.triangle(k), x).squared_distance);
        EXPECT_NEAR(std::abs(ground->at(x).gap), std::sqrt(nearest), 1e-12);
    }
}

TEST(SurfaceGround, OfASphereConvergesToIt)
{
    std::array<double, 2> worst{};
    for (int round = 0; round < 2; ++round) {
        const auto ground = make_surface_ground(sphere(round == 0 ? 20 : 40), "sphere");
        std::mt19937 random(5);
        std::normal_distribution<double> any(0, 1);
        for (int i = 0; i < 300; ++i) {
            const Vector3d x = Vector3d(any(random), any(random), any(random)).normalized() * (1 + 0.1 * any(random));
            worst[round] = std::max(worst[round], std::abs(ground->at(x).gap - (x.norm() - 1)));
        }
    }
    EXPECT_LT(worst[1], 0.3 * worst[0]); // of second order
    EXPECT_LT(worst[0], 1 - std::cos(M_PI / 20));
}

TEST(SurfaceGround, EndsAtItsRim)
{
    const TriangleMesh sheet = join({{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(1, 1, 0)},
                                     {Vector3d(0, 0, 0), Vector3d(1, 1, 0), Vector3d(0, 1, 0)}});
    const auto ground = make_surface_ground(sheet, "sheet");
    EXPECT_NEAR(ground->at({0.2, 0.7, -0.1}).gap, -0.1, 1e-15);
    EXPECT_NEAR(ground->at({1.3, 0.5, -0.4}).gap, 0.5, 1e-15); // beyond it, below: touches nothing
    EXPECT_NEAR(ground->at({1.0, 0.5, -0.1}).gap, -0.1, 1e-15);
}

/// What has diverged touches nothing, and does not crash.
TEST(SurfaceGround, HasNoGapToAPointThatIsNoNumber)
{
    const auto ground = make_surface_ground(cube(), "cube");
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_TRUE(std::isnan(ground->at({0.5, bad, 0.5}).gap));
}

TEST(SurfaceGround, RefusesWhatIsNoSurface)
{
    const Vector3d a(0, 0, 0), b(1, 0, 0);
    const auto fan = join({{a, b, Vector3d(0, 1, 0)}, {a, b, Vector3d(0, 0, 1)}, {a, b, Vector3d(0, -1, 0)}});
    EXPECT_NE(refusal_of([&] { make_surface_ground(fan, "fan.stl"); }).find("3 triangles share the edge"),
              std::string::npos);
    EXPECT_NE(refusal_of([] { make_surface_ground({}, "empty.stl"); }).find("empty.stl"), std::string::npos);
}

TEST(PolylineGround, HasTheGroundOnItsRight)
{
    const std::string path = scratch("rivage_line.csv");
    std::ofstream(path) << "x[m],y[m]\n-1,0\n0,0\n1,1\n3,1\n";
    const auto ground = make_polyline_ground(path);
    EXPECT_NEAR(ground->at({-0.5, 0.2, 0}).gap, 0.2, 1e-15);
    EXPECT_NEAR(ground->at({2, 0.9, 0}).gap, -0.1, 1e-15);
    EXPECT_NEAR(ground->at({0.5, 0.7, 0}).gap, 0.2 / std::sqrt(2), 1e-15);
    expect_exact_slopes(*ground, {0.95, 1.3, 0}); // around the convex corner
    std::ofstream(path) << "x[m],y[m]\n0,0\n0,0\n";
    EXPECT_NE(refusal_of([&] { make_polyline_ground(path); }).find("are the same"), std::string::npos);
    std::filesystem::remove(path);
}

TEST(HeightFile, MayBeHdf5)
{
    const std::string path = scratch("rivage_heights_" + std::to_string(Communicator::world().rank()) + ".h5");
    const auto height = [](double x, double y) { return 0.1 * x + 0.2 * y * y; };
    {
        auto file = Hdf5File::create(path, Communicator::self());
        std::vector<double> x, y, heights;
        for (int i = 0; i < 5; ++i) x.push_back(0.1 * i);
        for (int j = 0; j < 4; ++j) y.push_back(-0.2 + 0.1 * j);
        for (const double at_x : x)
            for (const double at_y : y) heights.push_back(height(at_x, at_y));
        file.write_rows("/x", x.data(), x.size(), 1);
        file.write_rows("/y", y.data(), y.size(), 1);
        file.write_rows("/height", heights.data(), x.size(), 4);
        file.write_rows("/other", heights.data(), x.size(), 3);
    }
    const auto table = make_height_table(path, 3);
    EXPECT_NEAR(table->at(0.2, -0.1).value, height(0.2, -0.1), 1e-15);
    EXPECT_NEAR(table->at(0.25, -0.1).slope[0], 0.1, 1e-12);
    EXPECT_NE(refusal_of([&] { make_height_table(path, 2); }).find("height has 5 x 4 entries"), std::string::npos);
    std::filesystem::remove(path);
    EXPECT_NE(refusal_of([&] { make_height_table(path, 3); }).find(path), std::string::npos);
}

} // namespace

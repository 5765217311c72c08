// SPDX-License-Identifier: MIT
#include "coupler_lib/base/hdf5_file.hpp"
#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/setup/initial_state.hpp"
#include "sph_solver/setup/make_model.hpp"
#include "sph_solver/setup/water_body.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>

namespace sph {
namespace {

using Corners = std::vector<std::vector<double>>;

WaterConfig polygon(const Corners& corners) { return {.shape = "polygon", .points = corners}; }

template<int D> struct Whole {
    double volume = 0.0;
    Vec<D> centre = Vec<D>::Zero();
    double smallest = 1e300, largest = 0.0;

    explicit Whole(const WaterBody<D>& body)
    {
        for (std::int64_t k = 0; k < body.count(); ++k) {
            const auto point = body.point(k);
            volume += point.volume;
            centre += point.volume * point.position;
            smallest = std::min(smallest, point.volume);
            largest = std::max(largest, point.volume);
        }
        centre /= volume;
    }
};

std::string refusal(const std::function<void()>& act)
{
    try {
        act();
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::bad_input);
        return error.what();
    }
    return "";
}

TEST(Polygon, RectangleIsTheBoxPointByPoint)
{
    const auto box = make_water_body<2>({.low = {0.0, 0.0}, .high = {0.1, 0.14}}, 0.0071);
    for (const Corners& corners :
         {Corners{{0, 0}, {0.1, 0}, {0.1, 0.14}, {0, 0.14}}, Corners{{0, 0.14}, {0.1, 0.14}, {0.1, 0}, {0, 0}}}) {
        const auto same = make_water_body<2>(polygon(corners), 0.0071);
        ASSERT_EQ(same->count(), box->count());
        for (std::int64_t k = 0; k < box->count(); ++k) {
            EXPECT_NEAR((same->point(k).position - box->point(k).position).norm(), 0.0, 1e-14);
            EXPECT_NEAR(same->point(k).volume / box->point(k).volume, 1.0, 1e-12);
        }
    }
}

TEST(Polygon, SlopesKeepAreaAndCentroidAndNoSliver)
{
    const double slope = std::tan(std::numbers::pi / 6), length = 0.1, height = 0.14, dx = 0.002;
    const auto body =
        make_water_body<2>(polygon({{0, 0}, {length, slope * length}, {length, height}, {0, height}}), dx);
    const Whole<2> whole(*body);
    const double rise = slope * length, area = length * height - 0.5 * length * rise;
    const double cx = (length * height * length / 2 - 0.5 * length * rise * 2 * length / 3) / area;
    EXPECT_NEAR(whole.volume, area, 1e-14);
    EXPECT_NEAR(whole.centre.x(), cx, 1e-13);
    EXPECT_GT(whole.smallest, 0.45 * dx * dx);
    EXPECT_LT(whole.largest, 1.6 * dx * dx);
    for (std::int64_t k = 0; k < body->count(); ++k) EXPECT_TRUE(body->contains(body->point(k).position));
    EXPECT_DOUBLE_EQ(body->top(Vec<2>(0, 1)), height);
}

TEST(Polygon, NotchesAndCurvesKeepTheirArea)
{
    Corners comb = {{0, 0}, {1, 0}, {1, 1}, {0.83, 1}, {0.71, 0.31}, {0.64, 1}, {0.4, 0.97}, {0.33, 0.2}, {0.1, 1}};
    double area = 0.0;
    for (std::size_t k = 0; k < comb.size(); ++k) {
        const auto &a = comb[k], &b = comb[(k + 1) % comb.size()];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    for (const double dx : {0.3, 0.05, 0.013})
        EXPECT_NEAR(Whole<2>(*make_water_body<2>(polygon(comb), dx)).volume, area, 1e-13);
    Corners circle;
    for (int k = 0; k < 400; ++k)
        circle.push_back({std::cos(2 * std::numbers::pi * k / 400), std::sin(2 * std::numbers::pi * k / 400)});
    const Whole<2> disc(*make_water_body<2>(polygon(circle), 0.05));
    EXPECT_NEAR(disc.volume, 200 * std::sin(2 * std::numbers::pi / 400), 1e-13);
    EXPECT_NEAR(disc.centre.norm(), 0.0, 1e-13);
}

TEST(Polygon, RefusesWhatIsNoPolygon)
{
    const auto made = [](const Corners& corners) {
        return refusal([&] { make_water_body<2>(polygon(corners), 0.1); });
    };
    EXPECT_NE(made({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).find("crosses or touches itself"), std::string::npos);
    EXPECT_NE(made({{0, 0}, {1, 0}, {1, 0}, {0, 1}}).find("points 2 and 3 are the same"), std::string::npos);
    EXPECT_NE(made({{0, 0}, {1, 0}, {1, 0.01}}).find("half a particle spacing"), std::string::npos);
}

class Files : public testing::Test {
protected:
    void SetUp() override
    {
        int rank = 0;
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
        path = (std::filesystem::temp_directory_path() /
                (std::string("rivage_water_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
                 std::to_string(rank)))
                   .string();
    }
    void TearDown() override { std::filesystem::remove(path); }

    /// An octahedron |x|/a + |y|/b + |z|/c <= 1 about `centre`, normals outwards or inwards.
    void write_octahedron(const Vec<3>& axes, const Vec<3>& centre, bool outwards, int faces = 8)
    {
        std::ofstream file(path);
        file.precision(17);
        file << "solid octahedron\n";
        for (int k = 0; k < faces; ++k) {
            const Vec<3> sign((k & 1) != 0 ? -1 : 1, (k & 2) != 0 ? -1 : 1, (k & 4) != 0 ? -1 : 1);
            const bool turn = (sign.prod() < 0) == outwards;
            file << "outer loop\n";
            for (const int corner : {0, turn ? 2 : 1, turn ? 1 : 2}) {
                Vec<3> x = centre;
                x[corner] += sign[corner] * axes[corner];
                file << "vertex " << x[0] << " " << x[1] << " " << x[2] << "\n";
            }
            file << "endloop\n";
        }
        file << "endsolid\n";
    }

    std::string path;
};

TEST_F(Files, StlSolidKeepsVolumeAndCentroid)
{
    const Vec<3> axes(1.0, 0.8, 0.6), centre(0.3, -0.2, 0.1);
    for (const bool outwards : {true, false}) {
        write_octahedron(axes, centre, outwards);
        const auto body = make_water_body<3>({.shape = "stl", .file = path, .scale = 0.1}, 0.006);
        const Whole<3> whole(*body);
        EXPECT_NEAR(whole.volume, 4.0 / 3.0 * axes.prod() * 1e-3, 1e-15);
        EXPECT_NEAR((whole.centre - 0.1 * centre).norm(), 0.0, 1e-10);
        EXPECT_GT(whole.smallest, 0.4 * std::pow(0.006, 3));
        EXPECT_NEAR(body->top(Vec<3>(0, 0, 1)), 0.07, 1e-15);
        for (std::int64_t k = 0; k < body->count(); ++k) {
            const Vec<3> x = 10 * body->point(k).position - centre;
            EXPECT_LE(x.cwiseAbs().cwiseQuotient(axes).sum(), 1.0 + 1e-9);
        }
    }
}

TEST_F(Files, StlSolidWithAHoleIsRefused)
{
    write_octahedron(Vec<3>::Ones(), Vec<3>::Zero(), true, 7);
    const std::string message = refusal([&] { make_water_body<3>({.shape = "stl", .file = path}, 0.1); });
    EXPECT_NE(message.find("not closed: 3 edges"), std::string::npos) << message;
}

TEST_F(Files, ParticlesComeAsTheFileHasThem)
{
    {
        auto file = base::Hdf5File::create(path, base::Communicator::self());
        const std::vector<double> points = {0, 0, 0, 1, 0, 0, 1, 1, 0}, volumes = {1, 0.9, 0.8},
                                  densities = {1000, 1001, 999};
        const std::vector<double> velocities = {0, 0, 0, 1, 2, 0, 0, -1, 0};
        file.create_group("/step");
        file.write_rows("/step/points", points.data(), 3, 3);
        file.write_rows("/step/volume", volumes.data(), 3, 1);
        file.write_rows("/step/density", densities.data(), 3, 1);
        file.write_rows("/step/velocity", velocities.data(), 3, 3);
    }
    FluidConfig config;
    config.domain.gravity = {0.0, 0.0};
    config.resolution.spacing = 1.0;
    config.liquid.sound_speed = 10.0;
    config.water = {{.shape = "particles", .file = path, .group = "/step"}};
    const auto model = make_model<2>(config);
    const auto particles = initial_particles(config, model, base::Communicator::self());
    ASSERT_EQ(particles.size(), 3U);
    EXPECT_EQ(particles.position[2], Vec<2>(1, 1));
    EXPECT_DOUBLE_EQ(particles.mass[1], 1001 * 0.9);
    EXPECT_EQ(particles.momentum[1], particles.mass[1] * Vec<2>(1, 2));
    config.water[0].velocity = {{"x + 2*y"}, {"0"}};
    EXPECT_EQ(initial_particles(config, model, base::Communicator::self()).momentum[2], Vec<2>(999 * 0.8 * 3, 0));
    config.water[0].group = "/stop";
    EXPECT_NE(refusal([&] {
                  initial_particles(config, model, base::Communicator::self());
              }).find("no dataset '/stop/points'"),
              std::string::npos);
}

TEST_F(Files, ParticlesOnTopOfEachOtherAreRefused)
{
    {
        auto file = base::Hdf5File::create(path, base::Communicator::self());
        const std::vector<double> points = {0, 0, 1, 0, 1.05, 0}, volumes = {1, 1, 1};
        file.write_rows("/points", points.data(), 3, 2);
        file.write_rows("/volume", volumes.data(), 3, 1);
    }
    const std::string message = refusal([&] { make_water_body<2>({.shape = "particles", .file = path}, 1.0); });
    EXPECT_NE(message.find("rows 1 and 2 lie on top of each other"), std::string::npos) << message;
}

FluidConfig two_bodies(const WaterConfig& a, const WaterConfig& b)
{
    FluidConfig config;
    config.domain.gravity = {0.0, -9.81};
    config.resolution.spacing = 0.1;
    config.liquid.sound_speed = 30.0;
    config.water = {a, b};
    return config;
}

TEST(Overlap, IsRefusedForEveryPairOfShapesOnAllRanks)
{
    const auto world = base::Communicator::world();
    const WaterConfig disc{.shape = "disc", .centre = {1.5, 0.5}, .radius = 0.5};
    const WaterConfig triangle = polygon({{1.2, 0}, {3, 0}, {3, 1}});
    const auto message = [&](const WaterConfig& a, const WaterConfig& b) {
        const FluidConfig config = two_bodies(a, b);
        return refusal([&] { initial_particles(config, make_model<2>(config), world); });
    };
    EXPECT_EQ(message({.low = {0, 0}, .high = {1, 1}}, {.low = {1, 0}, .high = {2, 1}}), "");
    EXPECT_EQ(message({.low = {0, 0}, .high = {1, 1}}, polygon({{1, 0}, {2, 0}, {1, 1}})), "");
    EXPECT_EQ(message({.low = {0, 0}, .high = {1, 1}}, disc), "");
    EXPECT_NE(message({.low = {0, 0}, .high = {1.1, 1}}, disc).find("numbers 1 and 2 overlap"), std::string::npos);
    EXPECT_NE(message(disc, triangle).find("overlap"), std::string::npos);
    EXPECT_NE(message(triangle, {.low = {2.5, 0.3}, .high = {3.5, 1.3}}).find("overlap"), std::string::npos);
}

TEST(InitialFields, FollowTheirFormulas)
{
    FluidConfig config =
        two_bodies({.low = {0, 0}, .high = {1, 1}, .velocity = {{"-x"}, {"y"}}}, {.low = {2, 0}, .high = {3, 1}});
    config.initial.state = "field";
    config.initial.pressure = {"500*(1 - x^2 - y^2)", "fluid.toml:9:1"};
    const auto model = make_model<2>(config);
    const auto particles = initial_particles(config, model, base::Communicator::self());
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const Vec<2> x = particles.position[i], v = x[0] < 1 ? Vec<2>(-x[0], x[1]) : Vec<2>(0, 0);
        EXPECT_NEAR(model.eos.pressure(particles.mass[i] / particles.volume[i]), 500 * (1 - x.squaredNorm()), 1e-7);
        EXPECT_NEAR((particles.momentum[i] - particles.mass[i] * v).norm(), 0.0, 1e-12);
    }
    const auto message = [&](const std::string& pressure) {
        config.initial.pressure.text = pressure;
        return refusal([&] { initial_particles(config, model, base::Communicator::self()); });
    };
    EXPECT_NE(message("500*(1 - r^2)").find("fluid.toml:9:1: the formula \"500*(1 - r^2)\""), std::string::npos);
    EXPECT_NE(message("-1e6*x").find("no density gives less"), std::string::npos);
    config.initial.state = "uniform";
    EXPECT_NE(message("x").find("it must be a number"), std::string::npos);
}

TEST(InitialFields, BodiesMayHaveLevelsOfTheirOwn)
{
    const FluidConfig config =
        two_bodies({.low = {0, 0}, .high = {1, 1}, .level = 1.0}, {.low = {2, 0}, .high = {3, 2}});
    const auto particles = initial_particles(config, make_model<2>(config), base::Communicator::self());
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const Vec<2> x = particles.position[i];
        EXPECT_DOUBLE_EQ(particles.mass[i] / particles.volume[i],
                         hydrostatic_density(Tait{1000.0, 30.0}, 9.81, (x[0] < 1 ? 1 : 2) - x[1]));
    }
}

} // namespace
} // namespace sph

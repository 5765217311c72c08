// SPDX-License-Identifier: MIT
#include "sph_solver/output/energy_table.hpp"
#include "sph_solver/output/field_output.hpp"
#include "sph_solver/output/probes.hpp"
#include "sph_solver/output/state_hash.hpp"
#include "sph_solver/state/canonical_order.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace sph {
namespace {

const base::Communicator& world()
{
    static const base::Communicator comm = base::Communicator::world();
    return comm;
}

/// A square of 20 x 20 particles, dx = 0.1, pressure 1000 + 100 y, velocity (y, -x).
Particles<2> square()
{
    Particles<2> particles;
    particles.resize(400);
    particles.own_all();
    for (std::size_t i = 0; i < 400; ++i) {
        const Vec<2> x(0.05 + 0.1 * static_cast<double>(i % 20), 0.05 + 0.1 * static_cast<double>(i / 20));
        particles.id[i] = static_cast<std::int64_t>(i);
        particles.position[i] = x;
        particles.volume[i] = 0.01;
        particles.mass[i] = 10.0;
        particles.velocity[i] = Vec<2>(x[1], -x[0]);
        particles.momentum[i] = 10.0 * particles.velocity[i];
        particles.pressure[i] = 1000.0 + 100.0 * x[1];
        particles.density[i] = 1000.0;
    }
    return particles;
}

Particles<2> share(Particles<2> all)
{
    std::vector<std::uint8_t> mine(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        mine[i] = static_cast<int>(i) % world().size() == world().rank() ? 1 : 0;
    keep_particles(all, mine);
    return all;
}

Probes<2> probes()
{
    return {{{.name = "p", .quantity = "pressure", .point = {1.0, 1.0}},
             {.name = "v", .quantity = "velocity", .point = {1.0, 1.0}},
             {.name = "dry", .quantity = "pressure", .point = {9.0, 9.0}},
             {.name = "tip", .quantity = "front", .axis = "x"},
             {.name = "low", .quantity = "back", .low = {0.0, 1.0}, .high = {2.0, 2.0}, .axis = "y"},
             {.name = "none", .quantity = "front", .low = {5.0, 5.0}, .high = {6.0, 6.0}},
             {.name = "left", .quantity = "mass", .low = {0.0, 0.0}, .high = {1.0, 2.0}},
             {.name = "all", .quantity = "kinetic"},
             {.name = "sensor", .quantity = "wall_pressure", .point = {2.0, 1.0}, .axis = "x", .size = 0.52},
             {.name = "small", .quantity = "wall_pressure", .point = {2.0, 1.02}, .axis = "x", .size = 0.01},
             {.name = "lower", .quantity = "semi_axes", .low = {0.0, 0.0}, .high = {2.0, 1.0}},
             {.name = "nothing", .quantity = "semi_axes", .low = {5.0, 5.0}, .high = {6.0, 6.0}}},
            CubicSpline<2>(0.123),
            0.1};
}

TEST(Probes, NameTheirColumnsWithUnits)
{
    EXPECT_EQ(probes().columns(),
              (std::vector<std::string>{"p.pressure[Pa]", "v.vx[m/s]", "v.vy[m/s]", "dry.pressure[Pa]", "tip.front[m]",
                                        "low.back[m]", "none.front[m]", "left.mass[kg/m]", "all.kinetic[J/m]",
                                        "sensor.wall_pressure[Pa]", "small.wall_pressure[Pa]", "lower.semi_axis_1[m]",
                                        "lower.semi_axis_2[m]", "nothing.semi_axis_1[m]", "nothing.semi_axis_2[m]"}));
}

TEST(Probes, MeasureWhatTheySay)
{
    const auto values = probes().values(share(square()), world());
    EXPECT_NEAR(values.at(0), 1100.0, 1e-9);
    EXPECT_NEAR(values.at(1), 1.0, 1e-12);
    EXPECT_NEAR(values.at(2), -1.0, 1e-12);
    EXPECT_EQ(values.at(3), 0.0);
    EXPECT_NEAR(values.at(4), 2.0, 1e-12);
    EXPECT_NEAR(values.at(5), 1.0, 1e-12);
    EXPECT_TRUE(std::isnan(values.at(6)));
    EXPECT_NEAR(values.at(7), 2000.0, 1e-9);
    double kinetic = 0.0;
    for (const Vec<2>& v : square().velocity) kinetic += 5.0 * v.squaredNorm();
    EXPECT_NEAR(values.at(8), kinetic, 1e-9);
    EXPECT_NEAR(values.at(9), 1100.0, 1e-9);  // rows 0.75 to 1.25
    EXPECT_NEAR(values.at(10), 1105.0, 1e-9); // as wide as dx: the row at 1.05
    // a lattice of n points, dx apart, has the variance dx^2 (n^2 - 1)/12 along each direction
    EXPECT_NEAR(values.at(11), 2.0 * std::sqrt(0.01 * 399.0 / 12.0), 1e-12);
    EXPECT_NEAR(values.at(12), 2.0 * std::sqrt(0.01 * 99.0 / 12.0), 1e-12);
    EXPECT_TRUE(std::isnan(values.at(13)));
}

TEST(Probes, DoNotDependOnThePartition)
{
    const auto together = probes().values(share(square()), world());
    const auto alone = probes().values(square(), base::Communicator::self());
    for (std::size_t k = 0; k < alone.size(); ++k) {
        if (std::isnan(alone[k])) continue;
        EXPECT_EQ(together.at(k), alone[k]) << k;
    }
}

TEST(StateHash, IsTheSameForAnyPartitionAndOrder)
{
    const std::string alone = state_hash(square(), base::Communicator::self());
    EXPECT_EQ(alone.size(), 16U);
    EXPECT_EQ(state_hash(share(square()), world()), alone);
    Particles<2> sorted = square();
    sort_canonically(sorted, CellGrid<2>(0.3));
    EXPECT_EQ(state_hash(sorted, base::Communicator::self()), alone);
}

TEST(StateHash, SeesTheLastBitOfOneParticle)
{
    const std::string before = state_hash(square(), base::Communicator::self());
    Particles<2> changed = square();
    changed.momentum[77][1] = std::nextafter(changed.momentum[77][1], 1e9);
    EXPECT_NE(state_hash(changed, base::Communicator::self()), before);
    changed = square();
    std::swap(changed.mass[3], changed.volume[3]);
    EXPECT_NE(state_hash(changed, base::Communicator::self()), before);
}

/// A folder of this test on all ranks, removed at its end.
class Folder {
public:
    Folder()
        : path_(std::filesystem::temp_directory_path() /
                ("rivage_output_" + world().broadcast(std::to_string(getpid()))))
    {
        if (world().is_root()) std::filesystem::create_directories(path_);
        world().barrier();
    }
    ~Folder()
    {
        world().barrier();
        if (world().is_root()) std::filesystem::remove_all(path_);
    }
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

TEST(FieldOutput, WritesAPointCloudThatNamesItsFields)
{
    const Folder folder;
    FieldOutput<2> output(folder.path(), world());
    output.write(0.0, share(square()));
    output.write(0.5, share(square()));
    world().barrier();
    std::ifstream file(folder.path() + "/fields.xdmf");
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    for (const char* name : {"pressure", "velocity", "rank", "400", "fields.h5:/step_000001"}) {
        EXPECT_NE(text.find(name), std::string::npos) << name;
    }
}

TEST(EnergyTable, HasTheHousesColumns)
{
    const Folder folder;
    if (!world().is_root()) return;
    {
        EnergyTable table(folder.path(), 2);
        EnergyRow row;
        row.kinetic = 1.0;
        row.potential = 2.0;
        row.internal = 4.0;
        table.write(row);
    }
    std::ifstream file(folder.path() + "/energy.csv");
    std::string header, values;
    std::getline(file, header);
    std::getline(file, values);
    EXPECT_EQ(header.rfind(
                  "t[s],dt[s],kinetic[J/m],potential[J/m],internal[J/m],total[J/m],mass[kg/m],work_by_walls[J/m]", 0),
              0U);
    EXPECT_EQ(values.rfind("0,0,1,2,4,7,", 0), 0U);
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/config/fluid_config.hpp"

#include <gtest/gtest.h>
#include <string>

namespace sph {
namespace {

const std::string tank = R"(
[domain]
gravity = [0.0, -9.81]
[resolution]
spacing = 0.002
[fluid]
sound_speed = 30.0
[[water]]
low = [0.0, 0.0]
high = [0.1, 0.14]
[[walls]]
name = "tank"
shape = "box"
low = [0.0, 0.0]
high = [0.1, 0.2]
open = ["top"]
)";

FluidConfig read(const std::string& text)
{
    base::ConfigReader reader(base::ConfigDocument::parse(text, "fluid.toml"));
    return read_fluid_config(reader);
}

/// The message that the file is refused with; empty when it is accepted.
std::string refusal(const std::string& text)
{
    try {
        read(text);
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::bad_input);
        return error.what();
    }
    return "";
}

void expect_refusal(const std::string& text, const std::vector<std::string>& words)
{
    const std::string message = refusal(text);
    for (const std::string& word : words) {
        EXPECT_NE(message.find(word), std::string::npos) << "message: " << message << "\nlacks: " << word;
    }
}

std::string with(const std::string& from, const std::string& to)
{
    std::string text = tank;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, from.size(), to);
}

TEST(FluidConfig, FillsDefaults)
{
    const FluidConfig config = read(tank);
    EXPECT_EQ(config.domain.dimension, 2);
    EXPECT_DOUBLE_EQ(config.time.cfl, 0.6);
    EXPECT_DOUBLE_EQ(config.resolution.smoothing_length(), 1.23 * 0.002);
    EXPECT_EQ(config.numerics.limiter, "van_albada");
    EXPECT_TRUE(config.water.at(0).velocity.empty());
}

TEST(FluidConfig, RefusesMistypedKeysWithTheNearestName)
{
    expect_refusal(with("spacing = 0.002", "spacing = 0.002\nsmothing_ratio = 1.2"),
                   {"fluid.toml:6", "smothing_ratio", "'smoothing_ratio'"});
}

TEST(FluidConfig, RefusesNegativeAndMissingSizes)
{
    expect_refusal(with("0.002", "-0.002"), {"fluid.toml:5", "spacing", "-0.002"});
    expect_refusal(with("sound_speed = 30.0", ""), {"sound_speed", "fluid"});
    expect_refusal(with("high = [0.1, 0.14]", "high = [0.1, -0.14]"), {"fluid.toml", "no volume"});
}

TEST(FluidConfig, RefusesVectorsOfTheWrongDimension)
{
    expect_refusal(with("[0.0, -9.81]", "[0.0, 0.0, -9.81]"), {"gravity", "3 numbers", "2D"});
    expect_refusal(with("gravity = [0.0, -9.81]", "dimension = 3"), {"water.0.low", "2 numbers", "3D"});
}

TEST(FluidConfig, RefusesUnknownShapesAndChoices)
{
    expect_refusal(tank + "[numerics]\nlimiter = \"van_albeda\"\n", {"van_albeda", "van_albada"});
    expect_refusal(tank + "[[probes]]\nname = \"a\"\nquantity = \"front\"\naxis = \"z\"\n", {"3D only"});
}

TEST(FluidConfig, RefusesDryRunsAndDoubledNames)
{
    expect_refusal("[resolution]\nspacing = 0.1\n[fluid]\nsound_speed = 30.0\n", {"no water"});
    expect_refusal(tank + "[[walls]]\nname = \"tank\"\npoints = [[0, 0], [1, 0]]\n", {"\"tank\" exists already"});
    expect_refusal(tank + "[[walls]]\nname = \"w\"\npoints = [[0, 0], [0, 0]]\n", {"\"w\"", "the same"});
    expect_refusal(tank + "[[walls]]\nname = \"w\"\npoints = [[0, 0]]\n", {"\"w\"", "two points"});
}

TEST(FluidConfig, ReadsAMotionAndNamesAMistypedKeyInIt)
{
    const std::string piston = tank + "[[walls]]\nname = \"piston\"\npoints = [[0, 0], [0, 0.2]]\n";
    const FluidConfig config = read(piston + "motion = {translation = [\"0.01*t\", 0]}\n");
    EXPECT_FALSE(config.walls.at(0).motion.moves());
    EXPECT_EQ(config.walls.at(1).motion.translation.at(0).text, "0.01*t");
    expect_refusal(piston + "motion = {translaton = [\"0.01*t\", 0]}\n",
                   {"fluid.toml:20", "translaton", "'translation'"});
    expect_refusal(piston + "motion = \"t\"\n", {"fluid.toml:20", "wants a table"});
    expect_refusal(piston + "motion = {translation = [0]}\n", {"\"piston\"", "2 are needed"});
}

TEST(FluidConfig, DescribesEveryKey)
{
    auto reader = base::ConfigReader::describe();
    read_fluid_config(reader);
    for (const char* key : {"spacing", "sound_speed", "imbalance_limit", "open", "normal", "quantity"}) {
        EXPECT_NE(reader.help().find(key), std::string::npos) << key;
    }
}

/// Outward normal (t_y, -t_x) of a segment points into the box for every side.
TEST(WallShape, BoxNormalsPointInside2D)
{
    const WallShape box = wall_shape(read(tank).walls.at(0), 2);
    EXPECT_EQ(box.facets.size(), 3U);
    for (const auto& facet : box.facets) {
        const double* a = &box.vertices[2 * static_cast<std::size_t>(facet[0])];
        const double* b = &box.vertices[2 * static_cast<std::size_t>(facet[1])];
        const double inside = (b[1] - a[1]) * (0.05 - a[0]) - (b[0] - a[0]) * (0.1 - a[1]);
        EXPECT_GT(inside, 0.0);
    }
}

using Point = std::array<double, 3>;

Point corner(const WallShape& shape, int v)
{
    const double* x = &shape.vertices[3 * static_cast<std::size_t>(v)];
    return {x[0], x[1], x[2]};
}

/// (b - a) x (c - a) . (towards - a)
double side_of(const WallShape& shape, const std::array<int, 4>& facet, const Point& towards)
{
    const Point a = corner(shape, facet[0]), b = corner(shape, facet[1]), c = corner(shape, facet[2]);
    double product = 0.0;
    for (std::size_t d = 0; d < 3; ++d) {
        const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
        product += ((b[e] - a[e]) * (c[f] - a[f]) - (b[f] - a[f]) * (c[e] - a[e])) * (towards[d] - a[d]);
    }
    return product;
}

TEST(WallShape, BoxAndExtrudedNormalsPointIntoTheFluid3D)
{
    WallConfig box{.name = "box", .shape = "box", .low = {0, 0, 0}, .high = {1, 2, 3}, .open = {"front"}};
    const WallShape faces = wall_shape(box, 3);
    EXPECT_EQ(faces.facets.size(), 5U);
    for (const auto& facet : faces.facets) EXPECT_GT(side_of(faces, facet, {0.5, 1.0, 1.5}), 0.0);

    WallConfig floor{.name = "floor", .points = {{1, 0}, {0, 0}}, .depth = {0, 1}}; // solid on the left: below
    const WallShape slab = wall_shape(floor, 3);
    EXPECT_GT(side_of(slab, slab.facets.at(0), {0.5, 1.0, 0.5}), 0.0);
}

TEST(WallShape, ExtrudedPolylinesAreLookedAtInSpace)
{
    // Two numbers a point: read as three, these would be (1, 2, 3) twice.
    WallConfig bent{.name = "bent", .points = {{1, 2}, {3, 1}, {2, 3}}, .depth = {0, 1}};
    EXPECT_EQ(wall_shape(bent, 3).facets.size(), 2U);
    bent.depth = {1, 0};
    EXPECT_THROW(wall_shape(bent, 3), base::Error);
    bent.depth = {0, 1};
    bent.points[1] = bent.points[0];
    EXPECT_THROW(wall_shape(bent, 3), base::Error);
}

TEST(FluidConfig, WaterSaysWhatItsShapeLacks)
{
    const std::string box = "low = [0.0, 0.0]\nhigh = [0.1, 0.14]\n[[walls]]";
    expect_refusal(with(box, "shape = \"polygon\"\npoints = [[0, 0], [1, 0]]\n[[walls]]"),
                   {"three points", "it has 2"});
    expect_refusal(with(box, "shape = \"polygon\"\npoints = [[0, 0], [1, 0], [1]]\n[[walls]]"), {"1 numbers, not 2"});
    expect_refusal(with(box, "shape = \"stl\"\nfile = \"a.stl\"\n[[walls]]"), {"3D", "polygon"});
    expect_refusal(with(box, "shape = \"particles\"\n[[walls]]"), {"needs a file"});
    expect_refusal(with(box, box.substr(0, 36) + "\nfile = \"a.h5\"\n[[walls]]"), {"has no file"});
    expect_refusal(with(box, box.substr(0, 36) + "\nvelocity = [\"-x\"]\n[[walls]]"),
                   {"water.0.velocity", "1 numbers"});
    expect_refusal(with(box, box.substr(0, 36) + "\nvelocity = [true, 1]\n[[walls]]"), {"a number or a formula"});
}

TEST(FluidConfig, HydrostaticWaterTakesNoPressure)
{
    expect_refusal(tank + "[initial]\npressure = \"500*y\"\n", {"fluid.toml:18", "\"field\" or \"uniform\""});
    EXPECT_EQ(refusal(tank + "[initial]\nstate = \"field\"\npressure = \"500*y\"\n"), "");
}

TEST(FluidConfig, PathsOfWaterAreSeenFromTheFile)
{
    const std::string text = with("low = [0.0, 0.0]\nhigh = [0.1, 0.14]\n[[walls]]",
                                  "shape = \"particles\"\nfile = \"states/a.h5\"\n[[walls]]");
    base::ConfigReader reader(base::ConfigDocument::parse(text, "cases/tank/fluid.toml"));
    EXPECT_EQ(read_fluid_config(reader).water.at(0).file, "cases/tank/states/a.h5");
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "coupler_lib/base/config.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <gtest/gtest.h>

namespace {

struct Resolution {
    double spacing = 0, smoothing_ratio = 1.23;
    int layers = 3;
    std::string limiter = "van_albada";
    bool moving = false;
};

struct Wall {
    std::string name;
    std::vector<std::vector<double>> points;
};

base::Table<Resolution> resolution_table()
{
    return base::Table<Resolution>("particle size")
        .key("spacing", &Resolution::spacing, {.unit = "m", .doc = "dx", .positive = true, .required = true})
        .key("smoothing_ratio", &Resolution::smoothing_ratio, {.unit = "-", .doc = "h/dx", .min = 1, .max = 2})
        .key("layers", &Resolution::layers, {.doc = "layers", .min = 1})
        .key("limiter", &Resolution::limiter, {.doc = "limiter", .choices = {"van_albada", "none"}})
        .key("moving", &Resolution::moving, {.doc = "moves"});
}

base::Table<Wall> wall_table()
{
    return base::Table<Wall>("a wall").key("name", &Wall::name, {.doc = "name"}).key("points", &Wall::points, {.unit = "m", .doc = "corners", .required = true});
}

base::ConfigReader reader_of(const std::string& toml) { return base::ConfigReader(base::ConfigDocument::parse(toml, "fluid.toml")); }

/// The message of the error that reading `toml` ends with, or "" when it is fine.
std::string error_of(const std::string& toml)
{
    try {
        auto reader = reader_of(toml);
        reader.table("resolution", resolution_table());
        reader.tables("walls", wall_table());
        reader.named_tables("material", wall_table());
        reader.finish();
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::bad_input);
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Config, FillsStructsAndKeepsDefaults)
{
    auto reader = reader_of("[resolution]\nspacing = 2\nlimiter = 'none'\n[[walls]]\nname = 'floor'\npoints = [[0, 0.5], [1, 2]]\n[material.rubber]\npoints = []\n");
    const auto resolution = reader.table("resolution", resolution_table());
    const auto walls = reader.tables("walls", wall_table());
    const auto materials = reader.named_tables("material", wall_table());
    reader.finish();
    EXPECT_EQ(resolution.spacing, 2.0);
    EXPECT_EQ(resolution.limiter, "none");
    EXPECT_EQ(resolution.smoothing_ratio, 1.23);
    ASSERT_EQ(walls.size(), 1U);
    EXPECT_EQ(walls[0].points[0][1], 0.5);
    ASSERT_EQ(materials.size(), 1U);
    EXPECT_EQ(materials[0].first, "rubber");
}

TEST(Config, UsedTablesReadBackTheSame)
{
    auto reader = reader_of("[resolution]\nspacing = 0.1\n");
    reader.table("resolution", resolution_table());
    auto again = reader_of(reader.used());
    const auto resolution = again.table("resolution", resolution_table());
    again.finish();
    EXPECT_EQ(resolution.spacing, 0.1);
    EXPECT_EQ(resolution.layers, 3);
}

TEST(Config, UnknownKeyNamesPlaceAndNearestKey)
{
    const auto message = error_of("[resolution]\nspacing = 1\nsmothing_ratio = 1.3\n");
    EXPECT_TRUE(contains(message, "fluid.toml:3:1")) << message;
    EXPECT_TRUE(contains(message, "did you mean 'smoothing_ratio'")) << message;
}

TEST(Config, UnknownTableNamesNearestTable)
{
    const auto message = error_of("[resolution]\nspacing = 1\n[[wals]]\npoints = []\n");
    EXPECT_TRUE(contains(message, "fluid.toml:3") && contains(message, "did you mean 'walls'")) << message;
    EXPECT_TRUE(contains(error_of("[resolution]\nspacing = 1\n[material.rubber]\npoints = []\nE = 3\n"), "fluid.toml:5:1"));
}

TEST(Config, WrongValuesNamePlaceValueAndWhatIsAllowed)
{
    EXPECT_TRUE(contains(error_of("[resolution]\nspacing = -0.1\n"), "fluid.toml:2:1: 'spacing' = -0.1 must be positive"));
    EXPECT_TRUE(contains(error_of("[resolution]\nspacing = 'a'\n"), "'spacing' wants a number, not a string"));
    EXPECT_TRUE(contains(error_of("[resolution]\nspacing = nan\n"), "not a number"));
    EXPECT_TRUE(contains(error_of("[resolution]\nspacing = 1\nlayers = 1.5\n"), "'layers' wants an integer"));
    EXPECT_TRUE(contains(error_of("[resolution]\nspacing = 1\nsmoothing_ratio = 3\n"), "outside 1 ... 2"));
    EXPECT_TRUE(contains(error_of("[resolution]\nspacing = 1\nlimiter = 'van_albad'\n"), "did you mean 'van_albada'"));
    EXPECT_TRUE(contains(error_of("[resolution]\n"), "'spacing' is missing in [resolution]"));
    EXPECT_TRUE(contains(error_of("[resolution]\nspacin = 1\n"), "is 'spacin' meant?"));
    EXPECT_TRUE(contains(error_of(""), "'spacing' is missing"));
    EXPECT_TRUE(contains(error_of("resolution = 3"), "must be a table"));
    EXPECT_TRUE(contains(error_of("[resolution]\nspacing = 1\n[walls]\nname = 'x'"), "each headed [[walls]]"));
    EXPECT_TRUE(contains(error_of("[resolution\n"), "not TOML"));
}

TEST(Config, OverridesReplaceAndAreNamedInErrors)
{
    auto document = base::ConfigDocument::parse("[resolution]\nspacing = 1\n", "fluid.toml");
    document.override_key("resolution.spacing", "0.5");
    document.override_key("resolution.limiter", "none");
    base::ConfigReader reader(document);
    const auto resolution = reader.table("resolution", resolution_table());
    EXPECT_EQ(resolution.spacing, 0.5);
    EXPECT_EQ(resolution.limiter, "none");
    document.override_key("resolution.spacin", "2");
    base::ConfigReader wrong(document);
    wrong.table("resolution", resolution_table());
    try {
        wrong.finish();
        ADD_FAILURE() << "an unknown overridden key must be an error";
    } catch (const base::Error& error) {
        EXPECT_TRUE(contains(error.what(), "--set resolution.spacin=2")) << error.what();
    }
}

TEST(Config, MissingFileIsNamed)
{
    try {
        base::ConfigDocument::load("/no/such/file.toml");
        ADD_FAILURE() << "a missing file must be an error";
    } catch (const base::Error& error) {
        EXPECT_TRUE(contains(error.what(), "/no/such/file.toml"));
    }
}

TEST(Config, HelpDescribesEveryKey)
{
    auto reader = base::ConfigReader::describe();
    reader.table("resolution", resolution_table());
    reader.tables("walls", wall_table());
    EXPECT_TRUE(contains(reader.help(), "smoothing_ratio"));
    EXPECT_TRUE(contains(reader.help(), "default 1.23"));
    EXPECT_TRUE(contains(reader.help(), "[[walls]]"));
}

}  // namespace

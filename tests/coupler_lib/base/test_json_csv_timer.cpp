// SPDX-License-Identifier: MIT
#include "coupler_lib/base/csv.hpp"
#include "coupler_lib/base/json.hpp"
#include "coupler_lib/base/timer.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace {

TEST(Json, KeepsOrderEscapesAndNests)
{
    base::JsonObject inside, object;
    inside.set("n", 3);
    object.set("b", 0.5).set("a", "say \"x\"\n").set("nan", std::nan("")).set("in", inside).set("b", true);
    EXPECT_EQ(object.text(), "{\n  \"b\": true,\n  \"a\": \"say \\\"x\\\"\\u000a\",\n  \"nan\": null,\n  \"in\": {\n    \"n\": 3\n  }\n}");
}

TEST(Csv, WritesHeaderAndRowsInFullPrecision)
{
    const auto path = (std::filesystem::temp_directory_path() / "rivage_test.csv").string();
    {
        base::CsvWriter csv(path, {"t[s]", "x[m]"});
        csv.row({0.1, 1.0 / 3.0});
    }
    std::ifstream file(path);
    std::stringstream content;
    content << file.rdbuf();
    EXPECT_EQ(content.str(), "t[s],x[m]\n0.1,0.3333333333333\n");
    std::filesystem::remove(path);
    EXPECT_THROW(base::CsvWriter("/no/such/folder/x.csv", {"a"}), base::Error);
}

TEST(TimerTree, NestsScopesAndCountsCalls)
{
    base::TimerTree timers;
    for (int k = 0; k < 3; ++k) {
        const auto step = timers.scope("step");
        const auto inner = timers.scope("gradients");
    }
    const std::string text = timers.json().text();
    EXPECT_NE(text.find("\"step\""), std::string::npos);
    EXPECT_NE(text.find("\"calls\": 3"), std::string::npos);
    EXPECT_LT(text.find("\"inside\""), text.find("\"gradients\""));
    EXPECT_GE(timers.seconds("step"), timers.seconds("gradients"));
}

}  // namespace

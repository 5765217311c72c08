// SPDX-License-Identifier: MIT
#include "coupler_lib/base/config.hpp"
#include "coupler_lib/base/expression.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using base::Expression;

double value(const std::string& formula, double x = 0.0, double y = 0.0)
{
    return Expression({formula, ""}, {"x", "y"})({x, y});
}

std::string error_of_formula(const std::string& formula, double x = 0.0)
{
    try {
        Expression({formula, "fluid.toml:7:1"}, {"x", "y"})({x, 1.0});
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::bad_input);
        return error.what();
    }
    return "";
}

TEST(Expression, FollowsTheRulesOfArithmetic)
{
    EXPECT_DOUBLE_EQ(value("500*(1 - x^2 - y^2)", 0.5, 0.25), 500 * (1 - 0.25 - 0.0625));
    EXPECT_EQ(value("-x", 3.0), -3.0);
    EXPECT_EQ(value("-x^2", 3.0), -9.0);
    EXPECT_EQ(value("2^3^2"), 512.0);
    EXPECT_EQ(value("x > 1 ? 2 : 3", 1.5), 2.0);
    EXPECT_EQ(value("1e-3*x", 2.0), 2e-3);
    EXPECT_DOUBLE_EQ(value("0.01*(1 - cos(2*pi*x/0.5))/2", 0.25), 0.01);
    EXPECT_DOUBLE_EQ(value("sin(pi/2) + exp(0) + ln(1) + sqrt(4) + abs(-1) + max(x, y)", 1.0, 2.0), 7.0);
}

TEST(Expression, MovesAndIsEvaluatedAnew)
{
    std::vector<Expression> several;
    for (int k = 0; k < 5; ++k)
        several.emplace_back(base::Formula{"x + " + std::to_string(k), ""}, std::vector<std::string>{"x"});
    for (int k = 0; k < 5; ++k) EXPECT_EQ(several[static_cast<std::size_t>(k)]({10.0}), 10.0 + k);
    EXPECT_EQ(several[1]({20.0}), 21.0);
}

TEST(Expression, KnowsItsVariables)
{
    const Expression only_x({"x*sin(x)", ""}, {"x", "t"});
    EXPECT_TRUE(only_x.uses("x"));
    EXPECT_FALSE(only_x.uses("t"));
}

TEST(Expression, ErrorsNamePlaceTextPositionAndVariables)
{
    const std::string unknown = error_of_formula("1 + sinn(z)");
    EXPECT_NE(unknown.find("fluid.toml:7:1"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("\"1 + sinn(z)\""), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("position 5"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("variables here: x, y"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("position 5: Unexpected token \"sinn\" found;"), std::string::npos) << unknown;
    EXPECT_NE(error_of_formula("(1 + x").find("cannot be read"), std::string::npos);
    EXPECT_NE(error_of_formula("").find("cannot be read"), std::string::npos);
    EXPECT_NE(error_of_formula("x = 3").find("position 3"), std::string::npos);
    EXPECT_NE(error_of_formula("1, 2").find("position 2"), std::string::npos);
    EXPECT_EQ(error_of_formula("x <= 3 && y != 2 && x == 0"), "");
}

TEST(Expression, NoFiniteValueIsAnErrorWithTheValues)
{
    const std::string root = error_of_formula("sqrt(x)", -4.0);
    EXPECT_NE(root.find("no finite value at x = -4, y = 1"), std::string::npos) << root;
    EXPECT_NE(error_of_formula("1/x").find("no finite value"), std::string::npos);
}

struct Field {
    base::Formula pressure = {"0", ""};
    std::vector<base::Formula> velocity = {};
};

TEST(Formula, IsAKeyThatTakesNumbersAndTexts)
{
    const auto table =
        base::Table<Field>("field").key("pressure", &Field::pressure, {}).key("velocity", &Field::velocity, {});
    base::ConfigReader reader(base::ConfigDocument::parse("[f]\npressure = 2.5\nvelocity = [\"-x\", 1]", "a.toml"));
    const Field field = reader.table("f", table);
    EXPECT_EQ(field.pressure.text, "2.5");
    ASSERT_EQ(field.velocity.size(), 2U);
    EXPECT_EQ(field.velocity[0].text, "-x");
    EXPECT_EQ(field.velocity[1].text, "1");
    EXPECT_EQ(field.pressure.where.rfind("a.toml:2", 0), 0U);
    EXPECT_NE(reader.used().find("pressure = 2.5\nvelocity = [\"-x\", 1.0]"), std::string::npos) << reader.used();
    base::ConfigReader wrong(base::ConfigDocument::parse("[f]\npressure = true", "a.toml"));
    EXPECT_THROW(wrong.table("f", table), base::Error);
}

} // namespace

// SPDX-License-Identifier: MIT
// What --check finds in the participants' descriptions of themselves.
#include "coupler_lib/foundation/check.hpp"
#include "coupler_lib/session/data_flow_check.hpp"

#include <gtest/gtest.h>

namespace {

using coupler::DataFlow;
using coupler::FlowReport;

/// The elastic gate at dx = 1 mm.
DataFlow water()
{
    DataFlow flow;
    flow.role = "fluid";
    flow.dimension = 2;
    flow.fields = coupler::interface_fields(2, {}, "fluid");
    flow.dt = 0.6 * 1.23e-3 / 30;
    flow.impedance = 1000 * 30;
    return flow;
}

DataFlow gate()
{
    DataFlow flow;
    flow.role = "solid";
    flow.dimension = 2;
    flow.fields = coupler::interface_fields(2, {}, "solid");
    flow.groups = {{"left", 40}, {"the free end", 4}};
    flow.density = 1100;
    flow.wave_speed = 153;
    flow.thickness = 0.005;
    return flow;
}

FlowReport check(const DataFlow& fluid, const DataFlow& solid, const std::string& scheme = "parallel_impedance")
{
    coupler::CouplingConfig config;
    config.time.end = 0.4;
    config.scheme.scheme = scheme;
    config.interfaces = {{}};
    return coupler::check_data_flow(config, {fluid, solid});
}

bool says(const std::vector<std::string>& lines, const std::string& piece)
{
    for (const auto& line : lines)
        if (line.find(piece) != std::string::npos) return true;
    return false;
}

TEST(DataFlow, ASoundCaseHasNoProblemAndNamesEveryField)
{
    const auto report = check(water(), gate());
    EXPECT_TRUE(report.problems.empty()) << report.problems.front();
    EXPECT_TRUE(report.advice.empty());
    EXPECT_TRUE(says(report.facts, "fluid -> solid: force [N/m]"));
    EXPECT_TRUE(says(report.facts, "solid -> fluid: acceleration [m/s^2]"));
    EXPECT_TRUE(says(report.facts, "'the free end': 4 facets"));
    EXPECT_TRUE(says(report.facts, "about 16260 steps"));
}

TEST(DataFlow, NamesWhatIsSentAndNotTaken)
{
    auto solid = gate();
    solid.fields = coupler::interface_fields(2, {.load = "averaged"}, "solid");
    const auto report = check(water(), solid);
    EXPECT_TRUE(says(report.problems, "fluid sends 'force' [N/m], but solid does not take it"));
    EXPECT_TRUE(says(report.problems, "solid needs 'pressure' [Pa], but fluid does not send it"));
}

/// Each solid is compared with what the fluid has for it.
TEST(DataFlow, OfTwoSolidsIsCheckedInterfaceByInterface)
{
    coupler::CouplingConfig config;
    config.time.end = 0.4;
    config.interfaces = {{.solid = "left"}, {.solid = "right", .load = "averaged"}};
    auto fluid = water(), left = gate(), right = gate();
    fluid.fields.clear();
    for (const auto& interface : config.interfaces)
        for (const auto& field : coupler::interface_fields(2, interface, "fluid")) fluid.fields.push_back(field);
    left.role = "left";
    right.role = "right";
    left.fields = coupler::interface_fields(2, config.interfaces[0], "left");
    right.fields = coupler::interface_fields(2, config.interfaces[1], "right");
    const auto report = coupler::check_data_flow(config, {fluid, left, right});
    EXPECT_TRUE(report.problems.empty()) << report.problems.front();
    EXPECT_TRUE(says(report.facts, "fluid -> left: force [N/m]"));
    EXPECT_TRUE(says(report.facts, "fluid -> right: pressure [Pa]"));
    std::swap(left.fields, right.fields);
    for (auto* side : {&left, &right})
        for (auto& field : side->fields) field.partner = "fluid";
    const auto crossed = coupler::check_data_flow(config, {fluid, left, right});
    EXPECT_TRUE(says(crossed.problems, "left needs 'pressure' [Pa], but fluid does not send it"));
}

TEST(DataFlow, NamesUnitsAndDimensionsThatDiffer)
{
    auto solid = gate();
    solid.dimension = 3;
    solid.fields = coupler::interface_fields(3, {}, "solid");
    const auto report = check(water(), solid);
    EXPECT_TRUE(says(report.problems, "fluid sends 'force' in N/m, but solid takes it in N"));
    EXPECT_TRUE(says(report.problems, "fluid is 2D, solid is 3D"));
}

TEST(DataFlow, NamesAnEmptySurfaceAndOverruledTimes)
{
    auto solid = gate();
    solid.groups.emplace_back("dry", 0);
    solid.dt = 1e-3;
    solid.end = 1;
    const auto report = check(water(), solid);
    EXPECT_TRUE(says(report.problems, "'dry' has no facet"));
    EXPECT_TRUE(says(report.advice, "1 s, is overruled by 0.4 s"));
    EXPECT_TRUE(says(report.advice, "0.001 s, is not used"));
}

/// 0.13 ... 0.18 for the gate; doubling as many times as the layer that answers is thinner.
TEST(DataFlow, KnowsTheStabilityOfTheGate)
{
    EXPECT_NEAR(coupler::stability_number(water(), gate()), 30.0 * 1000 / (1100 * 153.0), 1e-12);
    auto thin = gate();
    thin.thickness = 0.0005;
    const auto report = check(water(), thin, "parallel");
    EXPECT_TRUE(says(report.facts, "rho c dt / m = 1.34"));
    EXPECT_TRUE(says(report.advice, "parallel_impedance"));
    EXPECT_FALSE(says(check(water(), thin).advice, "use [coupling] scheme"));
}

TEST(DataFlow, SurvivesTheMessage)
{
    const auto got = coupler::data_flow_from("noise before\n" + coupler::to_text(gate()));
    EXPECT_EQ(got.role, "solid");
    EXPECT_EQ(got.dimension, 2);
    EXPECT_EQ(got.fields.size(), gate().fields.size());
    EXPECT_EQ(got.groups, gate().groups);
    EXPECT_EQ(got.wave_speed, 153);
    EXPECT_THROW(coupler::data_flow_from("role solid"), base::Error);
    EXPECT_THROW(coupler::data_flow_from("rivage data flow 1\nrole solid\ncolour blue\n"), base::Error);
}

} // namespace

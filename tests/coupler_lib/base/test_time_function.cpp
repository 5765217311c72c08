// SPDX-License-Identifier: MIT
#include "coupler_lib/base/csv_table.hpp"
#include "coupler_lib/base/time_function.hpp"
#include "coupler_lib/foundation/check.hpp"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

namespace base {
namespace {

TEST(TimeFunction, DifferencesAreOfSixthOrder)
{
    const double omega = 4 * std::acos(-1.0);
    const auto wave = [&](double t) { return 0.01 * std::cos(omega * t); };
    const auto error = [&](double step) {
        const TimeValue v = with_derivatives(wave, step)(0.17);
        return std::array{v.rate + 0.01 * omega * std::sin(omega * 0.17),
                          v.acceleration + omega * omega * 0.01 * std::cos(omega * 0.17)};
    };
    const auto coarse = error(0.02), fine = error(0.01), small = error(2e-5);
    EXPECT_NEAR(std::log2(coarse[0] / fine[0]), 6, 0.1);
    EXPECT_NEAR(std::log2(coarse[1] / fine[1]), 6, 0.1);
    EXPECT_LT(std::abs(small[0]), 1e-12); // the promise of the header: 2 eps |f| / h
    EXPECT_LT(std::abs(small[1]), 1e-7);
}

TEST(TimeFunction, SplineGoesThroughItsPointsWithExactDerivatives)
{
    const std::vector<double> time{0, 0.1, 0.3, 0.4, 0.7}, value{0, 0.2, -0.1, 0.05, 0.3};
    const TimeFunction spline = spline_through(time, value);
    for (std::size_t k = 0; k < time.size(); ++k) EXPECT_NEAR(spline(time[k]).value, value[k], 1e-14);
    EXPECT_NEAR(spline(0).acceleration, 0, 1e-12);
    EXPECT_NEAR(spline(0.7).acceleration, 0, 1e-12);
    const double h = 1e-5;
    for (double t = 0.05; t < 0.7; t += 0.0613) {
        const TimeValue before = spline(t - h), here = spline(t), after = spline(t + h);
        EXPECT_NEAR(here.rate, (after.value - before.value) / (2 * h), 1e-6);
        EXPECT_NEAR(here.acceleration, (after.rate - before.rate) / (2 * h), 1e-5);
    }
    for (const double t : {0.1, 0.3, 0.4}) { // value, rate and acceleration are continuous
        EXPECT_NEAR(spline(t - 1e-12).rate, spline(t + 1e-12).rate, 1e-9);
        EXPECT_NEAR(spline(t - 1e-12).acceleration, spline(t + 1e-12).acceleration, 1e-8);
    }
    EXPECT_NEAR(spline(0.9).value, 0.3 + 0.2 * spline(0.7).rate, 1e-14); // goes on with the last rate
}

TEST(TimeFunction, SplineRefusesTimesThatDoNotAscend)
{
    EXPECT_THROW(spline_through({0, 1, 1}, {0, 0, 0}), Error);
    EXPECT_THROW(spline_through({0}, {0}), Error);
}

std::string message_of(const std::string& content, const std::string& column = "t")
{
    const std::string path = testing::TempDir() + "table.csv";
    std::ofstream(path) << content;
    try {
        read_csv(path).column(column);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(CsvTable, ReadsColumnsByNameAndNamesTheLineOfAnError)
{
    const std::string path = testing::TempDir() + "motion.csv";
    std::ofstream(path) << "# made up\nt[s], x[m]\n0, 1e-3\n\n0.5, -2\n";
    const CsvTable table = read_csv(path);
    EXPECT_EQ(table.column("x"), (std::vector<double>{1e-3, -2}));
    EXPECT_EQ(table.column("t[s]"), (std::vector<double>{0, 0.5}));
    EXPECT_NE(message_of("t,x\n1,2\n3,four\n").find("table.csv:3"), std::string::npos);
    EXPECT_NE(message_of("t,x\n1,2\n3\n").find("table.csv:3"), std::string::npos);
    EXPECT_NE(message_of("t,x\n1,2\n", "y").find("t, x"), std::string::npos);
    EXPECT_NE(message_of("# nothing\n").find("no rows"), std::string::npos);
}

} // namespace
} // namespace base

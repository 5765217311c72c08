// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace fem_test {

/// Notes a measured figure in the test's own report (--gtest_output), from which `./rivage verify solid` takes it.
inline void record(const std::string& name, double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.16g", value);
    testing::Test::RecordProperty("figure_" + name, text);
}

} // namespace fem_test

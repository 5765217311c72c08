// SPDX-License-Identifier: MIT
#include "sph_solver/numerics/pack_columns.hpp"
#include "tests/sph_solver/support/noise.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

std::array<Pack, 8> random_rows()
{
    sample::Noise noise(5);
    std::array<Pack, 8> rows;
    for (Pack& row : rows) {
        std::array<double, pack_lanes> numbers;
        for (double& number : numbers) number = noise();
        row = load_pack(numbers.data());
    }
    return rows;
}

TEST(Pack, ColumnsOfRows)
{
    sample::Noise noise(5);
    std::array<std::array<double, 16>, 8> rows;
    for (auto& row : rows)
        for (double& number : row) number = noise();
    const std::array<int, 8> index = {3, 1, 4, 0, 5, 7, 2, 6};
    const auto columns =
        load_columns<16>([&](int i) { return rows[static_cast<std::size_t>(i)].data(); }, index.data());
    for (std::size_t r = 0; r < pack_lanes; ++r)
        for (std::size_t c = 0; c < 16; ++c)
            EXPECT_EQ(columns[c][r], rows[static_cast<std::size_t>(index[r])][c]) << r << ' ' << c;
}

TEST(Pack, SumsHaveOneTreeWhateverTheRegister)
{
    std::array<std::array<double, 8>, 11> numbers;
    sample::Noise noise(7);
    PartSums<11> parts;
    for (std::size_t n = 0; n < 11; ++n) {
        for (double& number : numbers[n]) number = noise();
        for (std::size_t part = 0; part < pack_parts; ++part)
            parts[part][n] = load_pack(numbers[n].data() + part * pack_lanes);
    }
    const auto sums = sum_lanes_of(parts);
    for (std::size_t n = 0; n < 11; ++n) {
        const auto& a = numbers[n];
        EXPECT_EQ(sums[n], ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7]))) << n;
    }
}

TEST(Pack, LanesComputeWhatNumbersCompute)
{
    const auto rows = random_rows();
    for (std::size_t k = 0; k < pack_lanes; ++k) {
        EXPECT_EQ(square_root(rows[0] * rows[0])[k], square_root(rows[0][k] * rows[0][k]));
        EXPECT_EQ(multiply_add(rows[0], rows[1], rows[2])[k], multiply_add(rows[0][k], rows[1][k], rows[2][k]));
        EXPECT_EQ(maximum(rows[0], rows[1])[k], maximum(rows[0][k], rows[1][k]));
        EXPECT_EQ(select_positive(rows[0], rows[1], rows[2])[k], select_positive(rows[0][k], rows[1][k], rows[2][k]));
    }
}

} // namespace
} // namespace sph

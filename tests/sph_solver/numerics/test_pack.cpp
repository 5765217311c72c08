// SPDX-License-Identifier: MIT
#include "sph_solver/numerics/pack.hpp"
#include "tests/sph_solver/support/noise.hpp"

#include <gtest/gtest.h>

namespace sph {
namespace {

std::array<Pack, 8> random_rows()
{
    sample::Noise noise(5);
    std::array<Pack, 8> rows;
    for (Pack& row : rows) {
        std::array<double, pack_size> numbers;
        for (double& number : numbers) number = noise();
        row = load_pack(numbers.data());
    }
    return rows;
}

TEST(Pack, TransposeTurnsRowsIntoColumns)
{
    const auto rows = random_rows();
    const auto columns = transpose(rows);
    for (std::size_t r = 0; r < 8; ++r)
        for (std::size_t c = 0; c < 8; ++c) EXPECT_EQ(columns[c][r], rows[r][c]) << r << ' ' << c;
}

TEST(Pack, SumsOfManyPacksAreThoseOfEach)
{
    const auto rows = random_rows();
    const Pack eight = sum_lanes(rows);
    const auto three = sum_lanes_of(std::array<Pack, 3>{rows[3], rows[1], rows[2]});
    for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(eight[k], sum_lanes(rows[k])) << k;
    EXPECT_EQ(three[0], sum_lanes(rows[3]));
    EXPECT_EQ(three[2], sum_lanes(rows[2]));
}

TEST(Pack, LanesComputeWhatNumbersCompute)
{
    const auto rows = random_rows();
    for (int k = 0; k < pack_size; ++k) {
        EXPECT_EQ(square_root(rows[0] * rows[0])[k], square_root(rows[0][k] * rows[0][k]));
        EXPECT_EQ(multiply_add(rows[0], rows[1], rows[2])[k], multiply_add(rows[0][k], rows[1][k], rows[2][k]));
        EXPECT_EQ(maximum(rows[0], rows[1])[k], maximum(rows[0][k], rows[1][k]));
        EXPECT_EQ(select_positive(rows[0], rows[1], rows[2])[k], select_positive(rows[0][k], rows[1][k], rows[2][k]));
    }
}

} // namespace
} // namespace sph

// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/communicator.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace {

std::vector<double> random_terms(int count)
{
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> exponent(-30, 12), sign(-1, 1);
    std::vector<double> terms(static_cast<std::size_t>(count));
    for (double& term : terms) term = sign(generator) * std::pow(10.0, exponent(generator) / 3);
    return terms;
}

base::ReproducibleSum sum_of(const std::vector<double>& terms)
{
    base::ReproducibleSum sum;
    for (const double term : terms) sum.add(term);
    return sum;
}

TEST(ReproducibleSum, DoesNotDependOnTheOrder)
{
    auto terms = random_terms(2000);
    const auto forward = sum_of(terms);
    std::reverse(terms.begin(), terms.end());
    EXPECT_EQ(forward, sum_of(terms));
    std::shuffle(terms.begin(), terms.end(), std::mt19937(3));
    EXPECT_EQ(forward, sum_of(terms));
    long double reference = 0;
    for (const double term : terms) reference += term;
    EXPECT_NEAR(forward.value(), static_cast<double>(reference), 1e-12);
}

TEST(ReproducibleSum, OppositeTermsCancelExactly)
{
    base::ReproducibleSum sum;
    for (const double term : random_terms(100)) {
        sum.add(term);
        sum.add(-term);
    }
    EXPECT_EQ(sum.value(), 0.0);
}

TEST(ReproducibleSum, RefusesWhatIsNoNumberOrFarTooLarge)
{
    base::ReproducibleSum sum;
    EXPECT_THROW(sum.add(std::numeric_limits<double>::quiet_NaN()), base::Error);
    EXPECT_THROW(sum.add(std::numeric_limits<double>::infinity()), base::Error);
    EXPECT_THROW(sum.add(1e14), base::Error);
    EXPECT_NO_THROW(sum.add(1e13));
}

TEST(ReproducibleSum, DoesNotDependOnTheRanks)
{
    const auto world = base::Communicator::world();
    const auto terms = random_terms(1000);
    base::ReproducibleSum mine;
    for (std::size_t k = 0; k < terms.size(); ++k)
        if (static_cast<int>(k * k % 7) % world.size() == world.rank()) mine.add(terms[k]);
    EXPECT_EQ(world.total(mine), sum_of(terms));
    EXPECT_EQ(world.total(std::vector{mine, mine})[1], sum_of(terms));
}

TEST(ReproducibleSum, GivesBackWhatADoubleHolds)
{
    for (const double value : {1.0, -1.0, 0x1p-80, -0x1p-80, 3.0 * 0x1p-79, -5e-20, 0.1, -0.1, 1e9 + 0x1p-20, -1e13,
                               -(1.0 + 0x1p-52), 0x1p-16 - 0x1p-69, -0x1p-16}) {
        base::ReproducibleSum sum;
        sum.add(value);
        const double kept = std::ldexp(std::trunc(std::ldexp(value, 80)), -80); // the quantum is 2^-80
        EXPECT_EQ(sum.value(), kept) << value;
        EXPECT_LE(static_cast<double>(sum.coarse_magnitude()) * 0x1p-16, std::abs(value));
        EXPECT_GE((static_cast<double>(sum.coarse_magnitude()) + 1) * 0x1p-16, std::abs(value));
    }
}

} // namespace

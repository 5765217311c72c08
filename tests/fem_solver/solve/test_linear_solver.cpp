// SPDX-License-Identifier: MIT
#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/solve/band_solver.hpp"
#include "fem_solver/solve/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace fem;

/// Unsymmetric, with small diagonals that make pivoting necessary, and numbered at random.
Matrix scrambled_band(int n, int width)
{
    std::vector<Eigen::Triplet<double>> entries;
    const auto number = [&](int i) { return (i * 37) % n; }; // n and 37 share no factor
    for (int i = 0; i < n; ++i)
        for (int j = std::max(0, i - width); j <= std::min(n - 1, i + width); ++j)
            entries.emplace_back(number(i), number(j), i == j ? 1e-8 : std::sin(1.0 + 3.1 * i + 1.7 * j));
    Matrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

TEST(BandSolver, SolvesWhatNeedsPivoting)
{
    const Matrix matrix = scrambled_band(101, 4);
    BandSolver solver;
    for (int round = 0; round < 2; ++round) { // the second factorisation reuses the numbering
        solver.factorise(matrix);
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(101, -1, 2);
        EXPECT_LT((matrix * solver.solve(b) - b).norm(), 1e-9 * b.norm());
    }
    EXPECT_EQ(solver.factorisations(), 2);
}

TEST(BandSolver, SaysThatAMatrixIsSingular)
{
    Matrix matrix(3, 3);
    matrix.insert(0, 0) = 1;
    matrix.insert(1, 1) = 0;
    matrix.insert(2, 2) = 1;
    BandSolver solver;
    try {
        solver.factorise(matrix);
        FAIL() << "no error";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::numerical_failure);
        EXPECT_NE(std::string(error.what()).find("singular at unknown 1"), std::string::npos) << error.what();
    }
}

TEST(NewtonMonitor, JudgesContractionAndConvergence)
{
    Mesh one_node;
    one_node.coordinates = {0, 0};
    const DofMap dofs(one_node);
    NewtonMonitor newton({1e-6, 3, 0.1}, dofs);
    newton.start();
    EXPECT_FALSE(newton.converged(Eigen::Vector2d(1, 0), 1, 0));
    EXPECT_FALSE(newton.slow());
    EXPECT_FALSE(newton.converged(Eigen::Vector2d(0, -0.05), 1, 0));
    EXPECT_FALSE(newton.slow());
    EXPECT_EQ(newton.worst(), 1);
    EXPECT_FALSE(newton.converged(Eigen::Vector2d(0.04, 0), 1, 0));
    EXPECT_TRUE(newton.slow());
    EXPECT_FALSE(newton.exhausted());
    EXPECT_TRUE(newton.converged(Eigen::Vector2d(1e-7, 0), 1, 0));
    EXPECT_TRUE(newton.exhausted());
    newton.start();
    EXPECT_FALSE(newton.converged(Eigen::Vector2d(0, NAN), 1, 0));
    EXPECT_TRUE(newton.broken());
    EXPECT_EQ(newton.worst(), 1);
}

} // namespace

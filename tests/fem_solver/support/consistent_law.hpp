// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/elastic.hpp"

#include <gtest/gtest.h>

namespace fem_test {

/// By central differences: the stress is the slope of the energy, the tangent that of the stress.
/// \param scale of the law's moduli [Pa]
template<int D, class Law> void expect_consistent(const Law& law, const fem::Tensor<D>& f, double scale)
{
    const double h = 1e-6;
    const fem::Tensor<D> stress = law.stress(f);
    const fem::Tangent<D> tangent = law.tangent(f);
    for (int j = 0; j < D; ++j)
        for (int i = 0; i < D; ++i) {
            fem::Tensor<D> up = f, down = f;
            up(i, j) += h;
            down(i, j) -= h;
            EXPECT_NEAR((law.energy(up) - law.energy(down)) / (2 * h), stress(i, j), 2e-8 * scale) << i << j;
            const fem::Tensor<D> change = (law.stress(up) - law.stress(down)) / (2 * h);
            for (int l = 0; l < D; ++l)
                for (int k = 0; k < D; ++k)
                    EXPECT_NEAR(change(k, l), tangent(k + D * l, i + D * j), 2e-7 * scale) << k << l << i << j;
        }
}

} // namespace fem_test

// SPDX-License-Identifier: MIT
#include "fem_solver/material/stability.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "fem_solver/material/point_law.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace fem {
namespace {

constexpr int stretches = 400; // looked at on each side of 1

struct Path {
    const char* name;
    double second, third; // exponents of the other two stretches
};
constexpr std::array<Path, 3> paths{{{"uniaxial", -0.5, -0.5}, {"equibiaxial", 1, -2}, {"planar", 0, -1}}};

/// Least eigenvalue of dt_a/d ln l_b = l_a l_b dP_aa/dF_bb + delta_ab l_a P_aa, over the shear modulus.
double least_stiffness(const PointLaw<3>& law, const Eigen::Vector3d& stretch)
{
    const Eigen::Matrix3d f = stretch.asDiagonal();
    const Eigen::Matrix3d p = law.stress(f);
    const Tangent<3> a = law.tangent(f);
    Eigen::Matrix3d stiffness;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            stiffness(i, j) = stretch[i] * stretch[j] * a(4 * i, 4 * j) + (i == j) * stretch[i] * p(i, i);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(stiffness, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[0] / law.shear_modulus();
}

/// The first stretch from 1 to `end` that is not stable.
std::optional<double> first_unstable(const PointLaw<3>& law, const Path& path, double end)
{
    for (int k = 0; k <= stretches; ++k) {
        const double l = std::pow(end, static_cast<double>(k) / stretches);
        if (!(least_stiffness(law, {l, std::pow(l, path.second), std::pow(l, path.third)}) > 0)) return l;
    }
    return std::nullopt;
}

} // namespace

StabilityReport drucker_stability(const Law& law, double lowest, double highest)
{
    const auto point = make_point_law<3>(law);
    StabilityReport report;
    std::string unstable;
    for (const Path& path : paths) {
        if (const auto l = first_unstable(*point, path, lowest))
            unstable += base::text(unstable.empty() ? "" : ", ", path.name, " from ", *l, " down");
        if (const auto l = first_unstable(*point, path, highest))
            unstable += base::text(unstable.empty() ? "" : ", ", path.name, " from ", *l, " up");
    }
    report.stable = unstable.empty();
    report.text =
        base::text("Drucker stability for stretches ", lowest, " to ", highest,
                   " (uniaxial, equibiaxial, planar): ", report.stable ? "stable" : "not stable in " + unstable);
    return report;
}

} // namespace fem

// SPDX-License-Identifier: MIT
#include "fem_solver/material/plane_stress.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <cmath>

namespace fem {
namespace {

constexpr int max_iterations = 50;
constexpr double tolerance = 1e-13; // of P_33 over A_3333
constexpr int across = 8;           // place of F_33 among F's entries

class PlaneStress final : public PointLaw<2> {
public:
    explicit PlaneStress(std::unique_ptr<PointLaw<3>> law) : law_(std::move(law)) {}

    double energy(const Tensor<2>& f) const override { return law_->energy(in_space(f)); }
    Tensor<2> stress(const Tensor<2>& f) const override { return law_->stress(in_space(f)).topLeftCorner<2, 2>(); }
    Tangent<2> tangent(const Tensor<2>& f) const override
    {
        const Tangent<3> a = law_->tangent(in_space(f));
        Tangent<2> flat;
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) {
                const int row = r % 2 + 3 * (r / 2), column = c % 2 + 3 * (c / 2);
                flat(r, c) = a(row, column) - a(row, across) * a(across, column) / a(across, across);
            }
        return flat;
    }
    Eigen::Matrix3d cauchy(const Tensor<2>& f) const override { return law_->cauchy(in_space(f)); }
    bool finite() const override { return law_->finite(); }
    double shear_modulus() const override { return law_->shear_modulus(); }

private:
    /// F with the stretch across that leaves the faces free, by Newton from the one that keeps the volume.
    Eigen::Matrix3d in_space(const Tensor<2>& f) const
    {
        Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
        full.topLeftCorner<2, 2>() = f;
        double& stretch = full(2, 2);
        if (finite()) stretch = 1 / f.determinant();
        for (int i = 0; i < max_iterations; ++i) {
            const double step = law_->stress(full)(2, 2) / law_->tangent(full)(across, across);
            stretch = finite() ? std::max(stretch - step, 0.5 * stretch) : stretch - step;
            if (std::abs(step) <= tolerance * std::abs(stretch)) return full;
        }
        throw base::Error(base::ExitCode::numerical_failure,
                          base::text("plane stress: no stretch across the sheet frees its faces where det F = ",
                                     f.determinant(), " in the plane; is the law unstable in compression?"));
    }

    std::unique_ptr<PointLaw<3>> law_;
};

} // namespace

std::unique_ptr<PointLaw<2>> make_plane_stress(std::unique_ptr<PointLaw<3>> law)
{
    return std::make_unique<PlaneStress>(std::move(law));
}

} // namespace fem

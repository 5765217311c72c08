// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/point_law.hpp"
#include "fem_solver/material/softening.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace fem {

/// The law of a body's shape with what each of its integration points remembers: the largest energy that it has seen, where
/// the material softens. Without softening it remembers nothing and is the law itself.
template<int D> class ShapeLaw {
public:
    ShapeLaw(std::unique_ptr<PointLaw<D>> law, const Softening& softening, std::size_t points)
        : law_(std::move(law)), softening_(softening), peak_(softening.active() ? points : 0, 0.0)
    {}

    /// Energy that can still be had back [J/m^3].
    double energy(std::size_t point, const Tensor<D>& f) const
    {
        const double psi = law_->energy(f);
        return softens() ? softening_.stored(psi, peak_[point]) : psi;
    }
    Tensor<D> stress(std::size_t point, const Tensor<D>& f) const { return factor(point, f).value * law_->stress(f); }
    /// eta d2psi/dF2 + (d eta/d psi) P P, P the undamaged stress.
    Tangent<D> tangent(std::size_t point, const Tensor<D>& f) const
    {
        const auto [eta, slope] = factor(point, f);
        Tangent<D> a = eta * law_->tangent(f);
        if (slope == 0) return a;
        const Tensor<D> stress = law_->stress(f);
        const auto p = stress.reshaped();
        return a + slope * p * p.transpose();
    }
    Eigen::Matrix3d cauchy(std::size_t point, const Tensor<D>& f) const
    {
        return factor(point, f).value * law_->cauchy(f);
    }

    bool softens() const { return !peak_.empty(); }
    /// Remembers a deformation that has come about.
    void accept(std::size_t point, const Tensor<D>& f) { peak_[point] = std::max(peak_[point], law_->energy(f)); }
    /// Energy that never comes back [J/m^3].
    double lost(std::size_t point) const { return softening_.lost(peak_[point]); }

private:
    Softening::Factor factor(std::size_t point, const Tensor<D>& f) const
    {
        return softens() ? softening_.factor(law_->energy(f), peak_[point]) : Softening::Factor{1, 0};
    }

    std::unique_ptr<PointLaw<D>> law_;
    Softening softening_;
    std::vector<double> peak_; ///< of psi [J/m^3]
};

} // namespace fem

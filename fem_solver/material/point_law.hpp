// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/material.hpp"

#include <memory>

namespace fem {

/// A law as elements use it, whichever it is: one call for each function at each integration point, so that an element
/// shape is compiled once and not once for each law.
template<int D> class PointLaw {
public:
    virtual ~PointLaw() = default;

    virtual double energy(const Tensor<D>& f) const = 0;          ///< w [J/m^3]
    virtual Tensor<D> stress(const Tensor<D>& f) const = 0;       ///< P [Pa]
    virtual Tangent<D> tangent(const Tensor<D>& f) const = 0;     ///< dP/dF [Pa]
    virtual Eigen::Matrix3d cauchy(const Tensor<D>& f) const = 0; ///< see cauchy_stress
    virtual bool finite() const = 0;                              ///< det F > 0 is needed
    virtual double shear_modulus() const = 0;                     ///< at small strain [Pa]
};

template<int D> std::unique_ptr<PointLaw<D>> make_point_law(const Law& law);
/// The same with what a material assumes across the plane.
template<int D> std::unique_ptr<PointLaw<D>> make_point_law(const Material& material);

} // namespace fem

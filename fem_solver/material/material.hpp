// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/material/marlow.hpp"
#include "fem_solver/material/neo_hookean.hpp"
#include "fem_solver/material/neo_hookean_log.hpp"
#include "fem_solver/material/ogden.hpp"
#include "fem_solver/material/softening.hpp"

#include <variant>

namespace fem {

/// One of the known laws (Mooney-Rivlin is a case of Ogden's).
using Law = std::variant<SmallElastic, SaintVenantKirchhoff, NeoHookean, NeoHookeanLog, Ogden, Marlow>;

/// What two dimensions stand for: no stretch across the plane, or no stress.
enum class Sheet { plane_strain, plane_stress };

/// A law, the mass density in the reference state [kg/m^3], in 2D what is assumed across the plane, and what is lost.
struct Material {
    Law law;
    double density = 0;
    Sheet sheet = Sheet::plane_strain;
    Softening softening = {}; ///< of the law's shape; mixed formulation only
};

/// Cauchy stress of a law [Pa], always 3 x 3; plane strain brings its normal stress across the plane.
///
///     sigma = P F^T / det F    (finite kinematics),    sigma = P    (small)
template<class LawType, int D> Eigen::Matrix3d cauchy_stress(const LawType& law, const Tensor<D>& f)
{
    Eigen::Matrix3d full = Eigen::Matrix3d::Identity();
    full.topLeftCorner<D, D>() = f;
    const Eigen::Matrix3d p = law.template stress<3>(full);
    if constexpr (!LawType::finite) return p;
    return p * full.transpose() / full.determinant();
}

} // namespace fem

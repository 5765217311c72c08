// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace fem {

/// Reference gradients of the enhanced modes that cure linear elements of locking (incompatible modes in the form of
/// enhanced strains: J. C. Simo and F. Armero, Int. J. Numer. Meth. Engng 33 (1992) 1413).
///
///     F = I + sum_a u_a (x) grad N_a + sum_i alpha_i (x) G_i,     i = 1..D
///     G_i = (j_0 / j) J_0^-T grad_xi (xi_i^2 - 1)/2
///
/// J = dX/dxi and j = det J here, J_0 and j_0 at the element's centre; the factor j_0/j makes the integral of every
/// G_i vanish, so that constant stress does no work on the modes and the patch test holds. The modes add the bending
/// that a bilinear element lacks (shear locking) and set the volume free (volumetric locking). They belong to one
/// element and are condensed there. Under strong compression they can buckle: a mesh with Quad8 is the safer choice.
///
/// \param xi point in the reference element. \param jacobian_0 dX/dxi at the centre. \param ratio j_0 / j at xi.
/// \return D x D, column i is G_i [1/m].
template<int D>
Eigen::Matrix<double, D, D> enhanced_gradients(const Eigen::Matrix<double, D, 1>& xi,
                                               const Eigen::Matrix<double, D, D>& jacobian_0, double ratio)
{
    const Eigen::Matrix<double, D, D> diagonal = xi.asDiagonal();
    return ratio * jacobian_0.inverse().transpose() * diagonal;
}

} // namespace fem

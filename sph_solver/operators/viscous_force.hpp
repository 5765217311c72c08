// SPDX-License-Identifier: MIT
#pragma once

#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/operators/momentum_term.hpp"

namespace sph {

/// Laminar viscosity of a Newtonian liquid (Morris, Fox and Zhu 1997):
///
///     dP_i/dt = sum 2 mu w_i w_j (|W'|/r) (v_j - v_i)
///
/// mu times the Laplacian of v, momentum conserved pair by pair, kinetic energy only ever lost. On a lattice with
/// h = 1.23 dx it is right within 0.4 %, where the form along x_ij that conserves angular momentum as well (Monaghan and
/// Gingold 1983) makes a shear flow 18 % too thin. The price: at a free surface the traction mu dv/dn is taken for the full one, so
/// that a drop in rigid rotation is braked in its outermost layer.
///
/// A wall's image is a neighbour like any other: with v' = 2 v_w - v it drags (no slip), with the mirrored v' it does not.
template<int D> class ViscousForce : public MomentumTerm<D> {
public:
    /// \param viscosity mu [Pa s], positive.
    ViscousForce(double viscosity, const FluidModel<D>& model) : factor_(2 * viscosity), model_(model) {}

    void add(Rates<D>& rates, std::vector<Vec<D>>& sums, const PairRecords<D>& records,
             const ReachedNeighbours& neighbours, const RowSet& rows) const override;

    void add_at_walls(WallForces<D>& forces, const WallImages<D>& images, const Walls<D>& walls,
                      const PairRecords<D>& records) const override;

private:
    double factor_; ///< 2 mu [Pa s]
    FluidModel<D> model_;
};

} // namespace sph

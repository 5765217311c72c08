// SPDX-License-Identifier: MIT
#pragma once

#include "coupler_lib/foundation/reproducible_sum.hpp"
#include "sph_solver/numerics/fluid_model.hpp"
#include "sph_solver/operators/wall_images.hpp"
#include "sph_solver/state/particles.hpp"

#include <array>
#include <vector>

namespace sph {

/// What each owned particle near a wall gets from its images, and what the wall's points get.
template<int D> struct WallForces {
    std::vector<Vec<D>> on_particle; ///< dP_i/dt [N], one for each contact
    std::vector<double> dilation;    ///< dw_i/dt [m^D/s], likewise
    std::vector<Vec<D>> on_wall;     ///< at x_w of each plane [N]; those of a contact add up to minus on_particle
};

/// Makes `forces` anew from the pressure. Every image is a neighbour across whose face no mass passes:
///
///     force on i = -sum S p_e n,   dilation = sum S n.(v' - v_i)/2,   S = 2 w_i w' |W'|,   n = (x' - x_i)/|x' - x_i|
///
/// (v' of the dilation without what pushing adds.)
/// The opposite force goes to x_w of the plane; that of an image mirrored in two or three planes is resolved along
/// their normals, each part to its own wall.
/// \pre images.find for the present positions; records hold states and slopes of the present state.
template<int D>
void find_wall_forces(WallForces<D>& forces, const WallImages<D>& images, const Walls<D>& walls,
                      const PairRecords<D>& records, const FluidModel<D>& model);

/// Adds what particles get to their rates of momentum and volume.
template<int D> void add_wall_forces(Rates<D>& rates, const WallForces<D>& forces, const Walls<D>& walls);

/// Rates of work and loss at the walls, this rank's part [W], 2D [W/m].
struct WallPower {
    base::ReproducibleSum by_walls;                          ///< of the fixed bodies on the fluid, -sum F.v_w
    base::ReproducibleSum by_interface;                      ///< of the moving facets on the fluid, -sum F.v_w
    std::array<base::ReproducibleSum, 3> force_of_walls;     ///< of the fixed bodies on the fluid, -sum F [N]
    std::array<base::ReproducibleSum, 3> force_of_interface; ///< of the moving facets on the fluid [N]
    base::ReproducibleSum dissipation; ///< power in - (v.dP_i/dt - p dw_i/dt) of the images, summed over particles
};

/// Adds weight * (power of this evaluation) to `power`.
template<int D>
void add_wall_power(WallPower& power, double weight, const WallForces<D>& forces, const Walls<D>& walls,
                    const Particles<D>& particles);

} // namespace sph

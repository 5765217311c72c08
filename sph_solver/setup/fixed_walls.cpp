// SPDX-License-Identifier: MIT
#include "sph_solver/setup/fixed_walls.hpp"

#include "coupler_lib/foundation/check.hpp"

namespace sph {

template<int D> Walls<D> make_walls(const FluidConfig& config, const FluidModel<D>& model)
{
    WallSettings<D> settings;
    settings.spacing = config.resolution.spacing;
    settings.support = model.kernel.support();
    settings.gravity = model.gravity;
    Walls<D> walls(settings);
    for (const WallConfig& wall : config.walls) {
        const WallShape shape = wall_shape(wall, D);
        walls.add_fixed(shape.name, shape.vertices, shape.facets);
    }
    return walls;
}

template<int D> void require_dry_walls(const Walls<D>& walls, const base::Communicator& comm, double tolerance)
{
    const Penetration mine = walls.penetration();
    const std::int64_t count = comm.sum(mine.count);
    const double deepest = comm.max(mine.deepest);
    base::require_input(
        deepest <= tolerance, "water starts inside a wall: ", count, " particles, the deepest ", deepest,
        " dx; check [[water]] against [[walls]] (the solid is on the left of the walk through a wall's points)");
}

template Walls<2> make_walls(const FluidConfig&, const FluidModel<2>&);
template Walls<3> make_walls(const FluidConfig&, const FluidModel<3>&);
template void require_dry_walls(const Walls<2>&, const base::Communicator&, double);
template void require_dry_walls(const Walls<3>&, const base::Communicator&, double);

} // namespace sph

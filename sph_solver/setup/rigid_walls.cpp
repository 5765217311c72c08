// SPDX-License-Identifier: MIT
#include "sph_solver/setup/rigid_walls.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/setup/wall_motion.hpp"

namespace sph {
namespace {

constexpr double steps_per_passage = 0.3; // differences of a wall's motion look 3 * 0.3 dx/c0 to both sides

constexpr double push_share = 0.1; // of c0 for a spacing: up to 2 % of c0 for a particle on the wall

} // namespace

template<int D> Walls<D> make_walls(const FluidConfig& config, const FluidModel<D>& model, double end)
{
    WallSettings<D> settings;
    settings.spacing = config.resolution.spacing;
    settings.support = model.kernel.support();
    settings.gravity = model.gravity;
    settings.push_rate = push_share * config.liquid.sound_speed / settings.spacing;
    settings.trap_gap = config.numerics.trap_gap;
    Walls<D> walls(settings);
    const MotionSpan span{config.time.start, end, steps_per_passage * settings.spacing / config.liquid.sound_speed};
    for (const bool moves : {false, true}) {
        for (const WallConfig& wall : config.walls) {
            if (wall.motion.moves() != moves) continue;
            const WallShape shape = wall_shape(wall, D);
            const WallBody body{shape.name, !wall.slip};
            if (moves)
                walls.add_driven(body, shape.vertices, shape.facets, make_motion<D>(wall, span));
            else
                walls.add_fixed(body, shape.vertices, shape.facets);
        }
    }
    walls.start_step(config.time.start);
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

template Walls<2> make_walls(const FluidConfig&, const FluidModel<2>&, double);
template Walls<3> make_walls(const FluidConfig&, const FluidModel<3>&, double);
template void require_dry_walls(const Walls<2>&, const base::Communicator&, double);
template void require_dry_walls(const Walls<3>&, const base::Communicator&, double);

} // namespace sph

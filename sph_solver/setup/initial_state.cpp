// SPDX-License-Identifier: MIT
#include "sph_solver/setup/initial_state.hpp"

#include "coupler_lib/foundation/check.hpp"
#include "sph_solver/setup/water_body.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

template<int D> using Bodies = std::vector<std::unique_ptr<WaterBody<D>>>;

/// Two boxes that share more than a sliver of space would start with particles on top of each other.
void check_boxes(const std::vector<WaterConfig>& water, double spacing)
{
    for (std::size_t a = 0; a < water.size(); ++a) {
        for (std::size_t b = a + 1; b < water.size(); ++b) {
            if (water[a].shape != "box" || water[b].shape != "box") continue;
            bool overlap = true;
            for (std::size_t d = 0; d < water[a].low.size(); ++d) {
                const double shared =
                    std::min(water[a].high[d], water[b].high[d]) - std::max(water[a].low[d], water[b].low[d]);
                overlap = overlap && shared > 0.01 * spacing;
            }
            base::require_input(!overlap, "[[water]] numbers ", a + 1, " and ", b + 1,
                                " overlap; make their boxes meet at a face");
        }
    }
}

/// Whether a particle's own space, a cube less a fifth on each side, reaches into a body.
template<int D> bool reaches_into(const WaterBody<D>& body, const WaterPoint<D>& point)
{
    const double arm = 0.3 * std::pow(point.volume, 1.0 / D);
    for (int corner = 0; corner < (1 << D); ++corner) {
        Vec<D> x = point.position;
        for (int d = 0; d < D; ++d) x[d] += ((corner >> d) & 1) != 0 ? arm : -arm;
        if (body.contains(x)) return true;
    }
    return false;
}

/// This rank's share of the particles, made body by body, with the check that none lies in a body that is not its own.
template<int D> class Filling {
public:
    Filling(const FluidConfig& config, const FluidModel<D>& model) : config_(config)
    {
        for (const WaterConfig& water : config.water)
            bodies_.push_back(make_water_body<D>(water, config.resolution.spacing));
        const double level = highest(model.gravity);
        for (const WaterConfig& water : config.water) {
            densities_.push_back(initial_density(config, water, model, level));
            velocities_.push_back(initial_velocity<D>(water));
        }
    }

    [[nodiscard]] std::int64_t count() const
    {
        std::int64_t total = 0;
        for (const auto& body : bodies_) total += body->count();
        return total;
    }

    /// Particles number begin to end; to be called once.
    Particles<D> make(std::int64_t begin, std::int64_t end)
    {
        Particles<D> particles;
        particles.resize(static_cast<std::size_t>(end - begin));
        std::size_t body = 0;
        std::int64_t first_of_body = 0;
        for (std::int64_t id = begin; id < end; ++id) {
            while (id - first_of_body >= bodies_[body]->count()) first_of_body += bodies_[body++]->count();
            const WaterPoint<D> point = bodies_[body]->point(id - first_of_body);
            const auto i = static_cast<std::size_t>(id - begin);
            particles.id[i] = id;
            fill(particles, i, body, point);
            look_for_overlap(body, point);
        }
        particles.own_all();
        return particles;
    }

    /// Throws the same error on every rank. Collective.
    void require_no_overlap(const base::Communicator& comm) const
    {
        const std::int64_t worst = comm.max(overlap_);
        const auto bodies = static_cast<std::int64_t>(bodies_.size());
        base::require_input(worst < 0, "[[water]] numbers ", worst / bodies + 1, " and ", worst % bodies + 1,
                            " overlap; water may touch other water, not share its space");
    }

private:
    double highest(const Vec<D>& gravity) const
    {
        if (gravity.norm() == 0.0) return 0.0;
        const Vec<D> up = -gravity / gravity.norm();
        double level = bodies_.front()->top(up);
        for (const auto& body : bodies_) level = std::max(level, body->top(up));
        return level;
    }

    void fill(Particles<D>& particles, std::size_t i, std::size_t body, const WaterPoint<D>& point) const
    {
        const double density = point.density ? *point.density : densities_[body](point.position);
        Vec<D> velocity = point.velocity.value_or(Vec<D>::Zero());
        if (velocities_[body]) velocity = velocities_[body](point.position);
        particles.position[i] = point.position;
        particles.volume[i] = point.volume;
        particles.mass[i] = density * point.volume;
        particles.momentum[i] = particles.mass[i] * velocity;
    }

    void look_for_overlap(std::size_t body, const WaterPoint<D>& point)
    {
        for (std::size_t other = 0; other < bodies_.size(); ++other) {
            const bool boxes = config_.water[body].shape == "box" && config_.water[other].shape == "box";
            if (other == body || boxes || !reaches_into(*bodies_[other], point)) continue;
            const std::size_t pair = std::min(body, other) * bodies_.size() + std::max(body, other);
            overlap_ = std::max(overlap_, static_cast<std::int64_t>(pair));
        }
    }

    const FluidConfig& config_;
    Bodies<D> bodies_;
    std::vector<DensityField<D>> densities_;
    std::vector<VelocityField<D>> velocities_;
    std::int64_t overlap_ = -1; // first body times their number plus second body
};

} // namespace

template<int D>
Particles<D> initial_particles(const FluidConfig& config, const FluidModel<D>& model, const base::Communicator& comm)
{
    check_boxes(config.water, config.resolution.spacing);
    Filling<D> water(config, model);
    const std::int64_t total = water.count();
    Particles<D> particles = water.make(total * comm.rank() / comm.size(), total * (comm.rank() + 1) / comm.size());
    water.require_no_overlap(comm);
    return particles;
}

template Particles<2> initial_particles(const FluidConfig&, const FluidModel<2>&, const base::Communicator&);
template Particles<3> initial_particles(const FluidConfig&, const FluidModel<3>&, const base::Communicator&);

} // namespace sph

// SPDX-License-Identifier: MIT
#include "sph_solver/setup/initial_state.hpp"

#include "coupler_lib/foundation/check.hpp"

#include <algorithm>
#include <cmath>

namespace sph {
namespace {

template<int D> Vec<D> to_vec(const std::vector<double>& numbers) { return Eigen::Map<const Vec<D>>(numbers.data()); }

Limiter make_limiter(const std::string& name)
{
    if (name == "none") return Unlimited{};
    if (name == "first_order") return FirstOrder{};
    return VanAlbada{};
}

/// Density of the fluid at rest as a function of the place.
template<int D> class RestState {
public:
    using Bodies = std::vector<std::unique_ptr<WaterBody<D>>>;

    RestState(const FluidConfig& config, const FluidModel<D>& model, const Bodies& bodies)
        : eos_(model.eos), gravity_(model.gravity.norm())
    {
        if (config.initial.state == "uniform" || gravity_ == 0.0) {
            gravity_ = 0.0;
            uniform_density_ = eos_.density(config.initial.state == "uniform" ? config.initial.pressure : 0.0);
            return;
        }
        up_ = -model.gravity / gravity_;
        level_ = config.initial.level;
        if (std::isfinite(level_)) return;
        level_ = bodies.front()->top(up_);
        for (const auto& body : bodies) level_ = std::max(level_, body->top(up_));
    }

    [[nodiscard]] double density(const Vec<D>& x) const
    {
        return gravity_ == 0.0 ? uniform_density_ : hydrostatic_density(eos_, gravity_, level_ - up_.dot(x));
    }

private:
    Tait eos_;
    double gravity_;
    double uniform_density_ = 0.0;
    Vec<D> up_ = Vec<D>::Zero();
    double level_ = 0.0;
};

/// Two boxes that share more than a sliver of space would start with particles on top of each other.
void check_overlap(const std::vector<WaterConfig>& water, double spacing)
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

} // namespace

double hydrostatic_density(const Tait& eos, double gravity, double depth)
{
    constexpr double exponent = Tait::gamma - 1.0;
    const double head = exponent * gravity * std::max(depth, 0.0) / (eos.c0 * eos.c0);
    return eos.rho0 * std::pow(1.0 + head, 1.0 / exponent);
}

template<int D> FluidModel<D> make_model(const FluidConfig& config)
{
    return {CubicSpline<D>(config.resolution.smoothing_length()),
            Tait{config.liquid.density, config.liquid.sound_speed}, make_limiter(config.numerics.limiter),
            to_vec<D>(config.domain.gravity)};
}

template<int D>
Particles<D> initial_particles(const FluidConfig& config, const FluidModel<D>& model, const base::Communicator& comm)
{
    check_overlap(config.water, config.resolution.spacing);
    typename RestState<D>::Bodies bodies;
    std::int64_t total = 0;
    for (const WaterConfig& water : config.water) {
        bodies.push_back(make_water_body<D>(water, config.resolution.spacing));
        total += bodies.back()->count();
    }
    const RestState<D> rest(config, model, bodies);
    const std::int64_t begin = total * comm.rank() / comm.size();
    const std::int64_t end = total * (comm.rank() + 1) / comm.size();

    Particles<D> particles;
    particles.resize(static_cast<std::size_t>(end - begin));
    std::size_t body = 0;
    std::int64_t first_of_body = 0;
    for (std::int64_t id = begin; id < end; ++id) {
        while (id - first_of_body >= bodies[body]->count()) first_of_body += bodies[body++]->count();
        const WaterPoint<D> point = bodies[body]->point(id - first_of_body);
        const auto i = static_cast<std::size_t>(id - begin);
        particles.id[i] = id;
        particles.position[i] = point.position;
        particles.volume[i] = point.volume;
        particles.mass[i] = rest.density(point.position) * point.volume;
        particles.momentum[i] = particles.mass[i] * to_vec<D>(config.water[body].velocity);
    }
    particles.own_all();
    return particles;
}

template FluidModel<2> make_model(const FluidConfig&);
template FluidModel<3> make_model(const FluidConfig&);
template Particles<2> initial_particles(const FluidConfig&, const FluidModel<2>&, const base::Communicator&);
template Particles<3> initial_particles(const FluidConfig&, const FluidModel<3>&, const base::Communicator&);

} // namespace sph
